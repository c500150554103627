// duplicate_variable.hlsl:5:11: error: redefinition 'shade'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float shade = uv.x;
    float shade = uv.y;
    return shade;
}
