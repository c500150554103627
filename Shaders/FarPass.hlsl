// Penumbra: the main light's visibility at each pixel of the screen, beyond the cascades too.
//
// Computes:   FarShadows       the cascades' visibility, handed over to that of the ground before the shadow distance;
//                              with _PENUMBRA_CLOUDS times that of a layer of clouds. Without a keyword of the ground,
//                              all beyond is lit
//             FarShadowsAlone  that of the ground
// Source:     Far/HorizonAngles.hlsl with _PENUMBRA_FAR_HORIZON, Far/HeightFieldTrace.hlsl with _PENUMBRA_FAR_HEIGHTS;
//             Core/FarHandOver.hlsl; Far/CloudShadow.hlsl.
// Inputs:     those of ScreenPass.hlsl; source: the cascades' visibility, of the screen's size;
//             those of CloudUniforms.hlsl, and _PenumbraCloudTexture, of CloudMapPass.hlsl
//             _PenumbraShadowDistance         metres
//             _PenumbraGroundArea             corner and size of the ground, x and z, world space, metres
//             _PenumbraGroundHeights          metres of 0 and of 1; samples along x and z
//             _PenumbraGroundChannels         what the heights' red and green are multiplied with before they are added
//             _PenumbraGroundHeightsTexture, or _PenumbraHorizonFirstTexture and _PenumbraHorizonSecondTexture
//             _PenumbraFarShadowsParameters0, of Far/Parameters/FarShadowsParameters.hlsl
// Cost:       2 fetches where the cascades alone count, 1 more with clouds. Beyond their border 2 more with horizon
//             angles, or as many as steps.
// Guarantees: [0, 1], 1 on the sky. As what it reads, it includes the shadow strength, and no fade by distance.
// Use it:     after the pass that resolves the cascades. Receivers then must not fade at the shadow distance.
#ifndef PENUMBRA_FAR_PASS_HLSL
#define PENUMBRA_FAR_PASS_HLSL

#include "ScreenPass.hlsl"
#include "CloudUniforms.hlsl"
#include "../ShaderLibrary/Core/FarHandOver.hlsl"
#include "../ShaderLibrary/Core/Noise.hlsl"
#include "../ShaderLibrary/Far/CloudShadow.hlsl"
#include "../ShaderLibrary/Far/Parameters/FarShadowsParameters.hlsl"
#include "../ShaderLibrary/Far/HeightFieldTrace.hlsl"
#include "../ShaderLibrary/Far/HorizonAngles.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"

float4 _PenumbraShadowDistance;
float4 _PenumbraGroundArea;
float4 _PenumbraGroundHeights;
float4 _PenumbraGroundChannels;
float4 _PenumbraFarShadowsParameters0;

SAMPLER(sampler_PenumbraLinearClamp);

TEXTURE2D(_PenumbraCloudTexture);
TEXTURE2D(_PenumbraGroundHeightsTexture);
TEXTURE2D(_PenumbraHorizonFirstTexture);
TEXTURE2D(_PenumbraHorizonSecondTexture);

float GroundVisibility(float3 positionWS, float2 pixel, FarShadowsParameters parameters)
{
#if defined(_PENUMBRA_FAR_HEIGHTS)
    const GroundMap ground = BoundedGroundMap(_PenumbraGroundArea, _PenumbraGroundHeights.xy);
    HeightFieldRay ray;
    ray.channels = _PenumbraGroundChannels.xy;
    ray.nearestMetres = parameters.nearestMetres;
    ray.steps = parameters.heightSteps;
    ray.jitter = GradientNoise(pixel, uint(_PenumbraMainLightParams.z));
    return HeightFieldVisibility(TEXTURE2D_ARGS(_PenumbraGroundHeightsTexture, sampler_PenumbraLinearClamp),
                                 _PenumbraGroundHeights.zw, positionWS, _PenumbraTowardSun.xyz, _PenumbraTowardSun.w,
                                 ray, ground);
#elif defined(_PENUMBRA_FAR_HORIZON)
    const GroundMap ground = BoundedGroundMap(_PenumbraGroundArea, _PenumbraGroundHeights.xy);
    return HorizonAnglesVisibility(_PenumbraHorizonFirstTexture,
                                   TEXTURE2D_ARGS(_PenumbraHorizonSecondTexture, sampler_PenumbraLinearClamp),
                                   positionWS, _PenumbraTowardSun.xyz, _PenumbraTowardSun.w, ground);
#else
    return 1.0;
#endif
}

float CloudsAt(float3 positionWS)
{
#if defined(_PENUMBRA_CLOUDS)
    const CloudParameters parameters = UnpackCloudParameters(_PenumbraCloudParameters0, _PenumbraCloudParameters1);
    return ApplyPenumbraStrength(CloudVisibility(TEXTURE2D_ARGS(_PenumbraCloudTexture, sampler_PenumbraLinearClamp),
                                                 positionWS, _PenumbraTowardSun.xyz, LayerOfClouds(parameters)));
#else
    return 1.0;
#endif
}

float4 FarShadows(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    const float cascades = LOAD_TEXTURE2D_X(_PenumbraSourceTexture, pixel).x;
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, ViewOfThisEye(), pixel);
    if (!surface.seen) return 1.0;
    const FarShadowsParameters parameters = UnpackFarShadowsParameters(_PenumbraFarShadowsParameters0);
    const float distance = length(surface.positionWS - _WorldSpaceCameraPos);
    const float share = FarShare(distance, _PenumbraShadowDistance.x, parameters.handOverBorder);
    UNITY_BRANCH
    if (share <= 0.0) return cascades * CloudsAt(surface.positionWS);
    const float far = ApplyPenumbraStrength(GroundVisibility(surface.positionWS, input.positionCS.xy, parameters));
    return HandedOver(cascades, far, share) * CloudsAt(surface.positionWS);
}

float4 FarShadowsAlone(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, ViewOfThisEye(), int2(input.positionCS.xy));
    if (!surface.seen) return 1.0;
    const FarShadowsParameters parameters = UnpackFarShadowsParameters(_PenumbraFarShadowsParameters0);
    return ApplyPenumbraStrength(GroundVisibility(surface.positionWS, input.positionCS.xy, parameters));
}

#endif
