// mixed_swizzle.hlsl:5:19: error: vector swizzle selectors not from the same set 'xyba'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float4 colour = uv.xyxy;
    return colour.xyba;
}
