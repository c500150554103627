// penumbra-lint: disable-file=negative-pow
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    return pow(uv.x, 1.5);
}
