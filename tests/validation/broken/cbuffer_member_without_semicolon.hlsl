// cbuffer_member_without_semicolon.hlsl:4:22: error: expected ','
cbuffer UnityPerMaterial
{
    float4 _BaseColor
    float _Smoothness;
};
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return _BaseColor * _Smoothness;
}
