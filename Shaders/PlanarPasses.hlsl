// Penumbra: shadows flattened onto one plane.
//
// Computes:   PlanarShadow      the casters drawn flat onto the plane, where the camera sees the plane: how dark their
//                               shadow is, which falls with the height of what casts it
//             PlanarVisibility  1 less it, over the screen
// Source:     Blinn, "Me and my (fake) shadow" (1988); Core/PlanarShadow.hlsl.
// Inputs:     _PenumbraPlane: its unit normal, and the distance that the normal times a point of it is;
//             _PenumbraTowardSun: the direction towards the sun, unit; those of ScreenPass.hlsl; _BaseMap, _BaseColor
//             and _Cutoff with _ALPHATEST_ON; of PlanarVisibility _PenumbraSourceTexture; _PenumbraPlanarParameters0,
//             of PlanarParameters.hlsl.
// Cost:       a draw of the casters, 1 fetch for each fragment; 1 for each pixel of the screen.
// Guarantees: [0, 1]. Nothing but the plane receives: what is farther from it than planarToleranceMetres and a tenth of
//             a pixel's width there is lit. What lies in the plane casts nothing, and so the ground may be a caster
//             too. Drawn with the largest value kept, no pixel darkens twice. Triangles that reach below the plane are
//             left out.
// Use it:     for flat ground and a hard or fading shadow, without a shadow map. Not: for other receivers.
#ifndef PENUMBRA_PLANAR_PASSES_HLSL
#define PENUMBRA_PLANAR_PASSES_HLSL

#include "ScreenPass.hlsl"
#include "CasterMaterial.hlsl"
#include "Parameters/PlanarParameters.hlsl"
#include "../ShaderLibrary/Core/HeightFade.hlsl"
#include "../ShaderLibrary/Core/PlanarShadow.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"

static const float kInPlaneMetres = 1e-3;
static const float kTolerancePixels = 0.1;

float4 _PenumbraPlane;
float4 _PenumbraTowardSun;
float4 _PenumbraPlanarParameters0;

struct PlanarAttributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct PlanarVaryings
{
    float4 positionCS : SV_POSITION;
    float2 heightAndValid : TEXCOORD0;
#if defined(_ALPHATEST_ON)
    float2 uv : TEXCOORD1;
#endif
    UNITY_VERTEX_OUTPUT_STEREO
};

PlanarVaryings PlanarVertex(PlanarAttributes input)
{
    PlanarVaryings output;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    const float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
    const PlanarPoint flat = OntoPlane(positionWS, _PenumbraPlane, float4(_PenumbraTowardSun.xyz, 0.0));
    output.positionCS = TransformWorldToHClip(flat.position);
    output.heightAndValid = float2(flat.height, flat.valid ? 1.0 : 0.0);
#if defined(_ALPHATEST_ON)
    output.uv = MaterialCoordinates(input.uv);
#endif
    return output;
}

bool CameraSeesPlane(int2 pixel, float tolerance)
{
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, ViewOfThisEye(), pixel);
    if (!surface.seen) return false;
    const float away = abs(dot(_PenumbraPlane.xyz, surface.positionWS) - _PenumbraPlane.w);
    return away <= tolerance + kTolerancePixels * surface.metresPerPixel;
}

float4 PlanarShadow(PlanarVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const PlanarParameters parameters = UnpackPlanarParameters(_PenumbraPlanarParameters0);
    // A triangle with a corner that has no shadow is valid at its other corners alone.
    clip(input.heightAndValid.y - 0.9999);
    clip(input.heightAndValid.x - kInPlaneMetres);
#if defined(_ALPHATEST_ON)
    clip(MaterialAlpha(input.uv) - _Cutoff);
#endif
    clip(CameraSeesPlane(int2(input.positionCS.xy),
                         BoundedOrLow(parameters.planarToleranceMetres, 0.0, 1e3)) ? 1.0 : -1.0);
    return HeightFade(input.heightAndValid.x, parameters.planarFadeMetres);
}

float4 PlanarVisibility(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return 1.0 - BoundedOrLow(LOAD_TEXTURE2D_X(_PenumbraSourceTexture, int2(input.positionCS.xy)).x, 0.0, 1.0);
}

#endif
