// Penumbra: stencil shadow volumes.
//
// Computes:   SceneDepth     the casters' depth, as the camera sees them
//             CountVolumes   nothing: the pass's stencil state counts the faces of the volumes behind that depth
// Source:     Crow 1977; Heidmann 1991; counting behind the depth (z-fail) Carmack 2000, in Everitt and Kilgard 2002.
// Inputs:     vertices in object space; unity_ObjectToWorld, unity_MatrixVP; CasterMaterial.hlsl with _ALPHATEST_ON.
// Cost:       a draw of the scene, with 1 fetch with alpha test, and a draw of the volumes without any.
// Guarantees: both vertex programs compute positions by one function, so that a cap lies where its triangle does.
// Use it:     through Shaders/PenumbraShadowVolumes.shader, in whose order its passes run.
#ifndef PENUMBRA_SHADOW_VOLUME_PASSES_HLSL
#define PENUMBRA_SHADOW_VOLUME_PASSES_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"
#include "CasterMaterial.hlsl"

struct SceneAttributes
{
    float4 positionOS : POSITION;
#if defined(_ALPHATEST_ON)
    float2 uv : TEXCOORD0;
#endif
};

struct SceneVaryings
{
    float4 positionCS : SV_POSITION;
#if defined(_ALPHATEST_ON)
    float2 uv : TEXCOORD0;
#endif
};

float4 VolumePosition(float3 positionOS)
{
    return TransformWorldToHClip(TransformObjectToWorld(positionOS));
}

SceneVaryings SceneVertex(SceneAttributes input)
{
    SceneVaryings output;
    output.positionCS = VolumePosition(input.positionOS.xyz);
#if defined(_ALPHATEST_ON)
    output.uv = MaterialCoordinates(input.uv);
#endif
    return output;
}

void SceneDepth(SceneVaryings input)
{
#if defined(_ALPHATEST_ON)
    clip(MaterialAlpha(input.uv) - _Cutoff);
#endif
}

struct VolumeAttributes
{
    float4 positionOS : POSITION;
};

float4 VolumeVertex(VolumeAttributes input) : SV_POSITION
{
    return VolumePosition(input.positionOS.xyz);
}

void CountVolumes()
{
}

#endif
