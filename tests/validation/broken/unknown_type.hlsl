// unknown_type.hlsl:4:5: error: unknown variable 'flaot'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    flaot shade = uv.x;
    return shade;
}
