// The passes of Layers.technique.json over the casters: the nearest depth, and how many surfaces a texel has.
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"
TEXTURE2D(_BaseMap);
SAMPLER(sampler_BaseMap);
float4 _BaseMap_ST;
float4 _BaseColor;
float _Cutoff;
struct Attributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
};
struct Varyings
{
    float4 positionCS : SV_POSITION;
#if defined(_ALPHATEST_ON)
    float2 uv : TEXCOORD0;
#endif
};
Varyings Caster(Attributes input)
{
    Varyings output;
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
#if defined(_ALPHATEST_ON)
    output.uv = input.uv * _BaseMap_ST.xy + _BaseMap_ST.zw;
#endif
    return output;
}
void CutOut(Varyings input)
{
#if defined(_ALPHATEST_ON)
    clip(_BaseColor.a * _BaseMap.Sample(sampler_BaseMap, input.uv).a - _Cutoff);
#endif
}
void Nearest(Varyings input) { CutOut(input); }
float4 Layers(Varyings input) : SV_Target
{
    CutOut(input);
    return 1.0;
}
