// Penumbra: the main light's visibility at each pixel of the screen, past the objects that distance fields hold.
//
// Computes:   FieldShadows: the share of the sun's disc that the objects leave free; with _PENUMBRA_FIELD_HARD whether
//             its centre is free; with _PENUMBRA_FIELD_CONE the share by one cone for each object.
// Source:     Fields/DistanceFieldScene.hlsl.
// Inputs:     those of ScreenPass.hlsl and of Fields/DistanceFieldScene.hlsl; _PenumbraFieldTexture, of `penumbra bake
//             distance-field --objects N`; _PenumbraTowardSun: towards the sun, world space, unit; half its angular
//             diameter, radians; _PenumbraFieldShadowsParameters0, of Fields/Parameters/FieldShadowsParameters.hlsl
// Cost:       5 fetches of camera depth, up to 9 at edges; those of Fields/DistanceFieldScene.hlsl.
// Guarantees: [0, 1], 1 on the sky and on surfaces that are turned from the sun, which their own normal darkens. It
//             includes the shadow strength.
// Use it:     in place of a shadow map, for a few solid objects. Not: for the ground's own shadow, which no field
//             holds.
#ifndef PENUMBRA_FIELD_PASS_HLSL
#define PENUMBRA_FIELD_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Fields/DistanceFieldScene.hlsl"
#include "../ShaderLibrary/Fields/Parameters/FieldShadowsParameters.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"

float4 _PenumbraTowardSun;
float4 _PenumbraFieldShadowsParameters0;

TEXTURE3D(_PenumbraFieldTexture);
SAMPLER(sampler_PenumbraLinearClamp);

float4 FieldShadows(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, ViewOfThisEye(), int2(input.positionCS.xy));
    if (!surface.seen) return 1.0;
    const FieldShadowsParameters parameters = UnpackFieldShadowsParameters(_PenumbraFieldShadowsParameters0);
    // The normal that the depths give has either sign.
    const float3 towardCamera = _WorldSpaceCameraPos - surface.positionWS;
    const float3 normal = dot(surface.normalWS, towardCamera) < 0.0 ? -surface.normalWS : surface.normalWS;
#if defined(_PENUMBRA_FIELD_HARD)
    const float visibility =
        FieldSceneHardVisibility(TEXTURE3D_ARGS(_PenumbraFieldTexture, sampler_PenumbraLinearClamp),
                                 surface.positionWS, normal, _PenumbraTowardSun.xyz,
                                 parameters.fieldFarthestMetres, parameters.fieldSteps);
#elif defined(_PENUMBRA_FIELD_CONE)
    const float visibility =
        FieldSceneConeVisibility(TEXTURE3D_ARGS(_PenumbraFieldTexture, sampler_PenumbraLinearClamp),
                                 surface.positionWS, normal, _PenumbraTowardSun.xyz,
                                 parameters.fieldFarthestMetres, tan(_PenumbraTowardSun.w),
                                 parameters.fieldSteps);
#else
    const float visibility =
        FieldSceneSoftVisibility(TEXTURE3D_ARGS(_PenumbraFieldTexture, sampler_PenumbraLinearClamp),
                                 surface.positionWS, normal, _PenumbraTowardSun.xyz,
                                 parameters.fieldFarthestMetres, tan(_PenumbraTowardSun.w),
                                 parameters.fieldSteps);
#endif
    return ApplyPenumbraStrength(visibility);
}

#endif
