// Penumbra: a filtered shadow map from several depths for each texel.
//
// Computes:   CasterDepth  the casters' depth, drawn as URP draws them into its shadow map
//             MeanOfDepths the mean of what the samples' depths become (DepthMoments)
//             ValueRows    the rows of a separable Gaussian over that mean; the columns are MapColumns (MapPasses.hlsl)
// Source:     a filtered map is a mean of depths' functions, which samples of a texel join as neighbouring texels do:
//             Lauritzen and McCool, "Layered Variance Shadow Maps", 2008, section 3.
// Inputs:     those of MapPasses.hlsl; _PenumbraSampleDepths: of CasterDepth; of ValueRows _PenumbraSourceTexture: of
//             MeanOfDepths; _PenumbraMapSampleParameters0, of Filters/Prefiltered/Parameters/MapSampleParameters.hlsl;
//             of CasterDepth URP's _ShadowBias and _LightDirection, _BaseMap, _BaseColor and _Cutoff.
// Cost:       a draw of the casters for each cascade; as many fetches as samples; of the rows 1 + 2 ceil(2.5
//             deviation).
// Guarantees: finite for any depth; nothing outside of the tile is read.
// Use it:     in place of URP's shadow map, for filters of filtered maps. Not: for filters of depths, which have no
//             mean.
#ifndef PENUMBRA_MULTISAMPLED_MAP_PASSES_HLSL
#define PENUMBRA_MULTISAMPLED_MAP_PASSES_HLSL

#include "CasterMaterial.hlsl"
#include "VarianceMap.hlsl"
#include "../ShaderLibrary/Core/ShadowBias.hlsl"
#include "../ShaderLibrary/Filters/Prefiltered/Parameters/MapSampleParameters.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"

Texture2DMS<float> _PenumbraSampleDepths;
float4 _PenumbraMapSampleParameters0;

float3 _LightDirection;

static const int kMostMapSamples = 8;

struct CasterAttributes
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    float2 uv : TEXCOORD0;
};

struct CasterVaryings
{
    float4 positionCS : SV_POSITION;
#if defined(_ALPHATEST_ON)
    float2 uv : TEXCOORD0;
#endif
};

CasterVaryings CasterVertex(CasterAttributes input)
{
    CasterVaryings output;
    const float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
    const float3 normalWS = TransformObjectToWorldNormal(input.normalOS);
    output.positionCS = TransformWorldToHClip(BiasCaster(positionWS, normalWS, _LightDirection, _ShadowBias.xy));
#if defined(_ALPHATEST_ON)
    output.uv = MaterialCoordinates(input.uv);
#endif
    return output;
}

void CasterDepth(CasterVaryings input)
{
#if defined(_ALPHATEST_ON)
    clip(MaterialAlpha(input.uv) - _Cutoff);
#endif
}

float4 MeanOfDepths(ScreenVaryings input) : SV_Target
{
    const MapSampleParameters parameters = UnpackMapSampleParameters(_PenumbraMapSampleParameters0);
    const int samples = min(max(parameters.mapSamples, 1), kMostMapSamples);
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    UNITY_LOOP
    for (int i = 0; i < samples; ++i) sum += MapValue(_PenumbraSampleDepths.Load(int2(input.positionCS.xy), i).x);
    return sum / float(samples);
}

float4 ValueRows(ScreenVaryings input) : SV_Target
{
    const float deviation = MapDeviation();
    const int reach = MapBlurReach(deviation);
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
        const int2 texel = MapBlurTexel(int2(input.positionCS.xy), int2(i, 0), _PenumbraTile);
        const float weight = MapBlurWeight(i, deviation);
        sum += weight * LOAD_TEXTURE2D_X(_PenumbraSourceTexture, texel);
        weights += weight;
    }
    return sum / weights;
}

#endif
