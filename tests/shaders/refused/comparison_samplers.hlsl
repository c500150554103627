// comparison_samplers.hlsl:5: error: '_Compare' is a comparison sampler and this read does not compare; use a sampler like sampler_LinearClamp, or SAMPLE_TEXTURE2D_SHADOW
Texture2D<float4> _Map; SamplerComparisonState _Compare;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float4 a = _Map.Sample(_Compare, p.xy);
    return a;
}
