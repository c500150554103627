// stray_backslash.hlsl:4:24: error: '\' may only end a line
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float shade = uv.x \ 2.0;
    return shade;
}
