// matrix_of_wrong_size.hlsl:5: warning: mul() matrix size mismatch
float4x4 _ObjectToWorld;
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return mul(_ObjectToWorld, uv);
}
