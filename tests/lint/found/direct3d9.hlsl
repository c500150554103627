// direct3d9.hlsl:8:26: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 8: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// direct3d9.hlsl:9:26: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 9: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
// direct3d9.hlsl:12:14: warning: a texture is sampled with implicit derivatives where only some pixels of a quad may be active, by the condition at line 10: sample before the condition, or use SampleLevel or SampleGrad [divergent-derivative]
sampler2D _Map; samplerCUBE _Sky;
float4 Main(float4 uv : TEXCOORD0) : SV_Target
{
    float4 c = tex2D(_Map, uv.xy);
    if (uv.x > 0.5) c += tex2D(_Map, uv.yx);
    if (uv.y > 0.5) c += texCUBE(_Sky, uv.xyz);
    if (uv.z > 0.5)
    {
        c += tex2Dproj(_Map, uv * 2);
    }
    return c;
}
