// Penumbra: contact shadows, over the visibility that earlier passes made or alone.
//
// Computes:   Screen/ScreenTrace.hlsl towards the main light at this pixel, multiplied into the source.
// Source:     see there.
// Inputs:     those of ScreenPass.hlsl; source: visibility with the shadow strength, of the screen's size;
//             _PenumbraScreenTraceParameters0 and so on, of Screen/Parameters/ScreenTraceParameters.hlsl; URP's
//             _MainLightPosition and _MainLightShadowParams; _PenumbraMainLightParams of Pipelines/Urp.hlsl, z: the
//             frame's index.
// Cost:       1 fetch of the source, and where it is not dark those of the trace.
// Guarantees: [0, 1], 1 on the sky if the source is. Never lighter than the source, and no darker than the shadow
//             strength allows.
// Use it:     ScreenTrace after the last pass that makes a visibility, ScreenTraceAlone without one.
#ifndef PENUMBRA_SCREEN_TRACE_PASS_HLSL
#define PENUMBRA_SCREEN_TRACE_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"
#include "../ShaderLibrary/Screen/ScreenTrace.hlsl"

float4 _PenumbraScreenTraceParameters0;
float4 _PenumbraScreenTraceParameters1;
float4 _PenumbraScreenTraceParameters2;

float TracedVisibility(float2 positionCS)
{
    const float jitter = GradientNoise(positionCS, uint(max(_PenumbraMainLightParams.z, 0.0)));
    return ScreenTraceVisibility(_CameraDepthTexture, ViewOfThisEye(), int2(positionCS), _MainLightPosition.xyz, jitter,
                                 UnpackScreenTraceParameters(_PenumbraScreenTraceParameters0,
                                                             _PenumbraScreenTraceParameters1,
                                                             _PenumbraScreenTraceParameters2));
}

// The trace takes nothing of 1 - strength, which is all the light that there is in full shadow.
float4 ScreenTrace(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const float before = SanitizeVisibility(LOAD_TEXTURE2D_X(_PenumbraSourceTexture, int2(input.positionCS.xy)).x);
    const float least = ApplyPenumbraStrength(0.0);
    UNITY_BRANCH
    if (!(before > least)) return before;
    return SanitizeVisibility(least + (before - least) * TracedVisibility(input.positionCS.xy));
}

float4 ScreenTraceAlone(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return SanitizeVisibility(ApplyPenumbraStrength(TracedVisibility(input.positionCS.xy)));
}

#endif
