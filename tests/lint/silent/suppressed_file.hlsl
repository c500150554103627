// penumbra-lint: disable-file=divergent-derivative
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    if (uv.x > 0.5) uv.x += ddx(uv.y);
    return uv.xyxy;
}
