// Penumbra: the visibility that earlier passes made, averaged over frames.
//
// Computes:   Screen/Accumulation.hlsl at this pixel, and the history for the next frame.
// Source:     see there.
// Inputs:     those of ScreenPass.hlsl; source: visibility, of the screen's size, with noise that is new in each frame;
//             _PenumbraHistory: this pass's second output of the frame before, 0 where there was none;
//             _PenumbraToPreviousScreen   per eye: (uv, stored camera depth, 1) to the same of the frame before,
//                                         homogeneous.
// Cost:       9 fetches of the source and 1 of the depth, and 4 of history where there are penumbrae.
// Guarantees: [0, 1]. Where the source is the same for all pixels around, it stays.
// Use it:     after the last pass that makes a visibility. Moving surfaces have no history. Not: with static noise.
#ifndef PENUMBRA_ACCUMULATE_PASS_HLSL
#define PENUMBRA_ACCUMULATE_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Screen/Accumulation.hlsl"

float4x4 _PenumbraToPreviousScreen[2];

#if defined(UNITY_STEREO_INSTANCING_ENABLED) || defined(UNITY_STEREO_MULTIVIEW_ENABLED)
Texture2DArray<uint> _PenumbraHistory;
#define LOAD_HISTORY(pixel) _PenumbraHistory.Load(int4(pixel, SLICE_ARRAY_INDEX, 0))
#else
Texture2D<uint> _PenumbraHistory;
#define LOAD_HISTORY(pixel) _PenumbraHistory.Load(int3(pixel, 0))
#endif

struct AccumulateTargets
{
    float visibility : SV_Target0;
    uint history : SV_Target1;
};

float SourceAt(int2 pixel)
{
    const int2 inside = min(max(pixel, 0), int2(_PenumbraScreenSize.xy) - 1);
    return SanitizeVisibility(LOAD_TEXTURE2D_X(_PenumbraSourceTexture, inside).x);
}

// The history of the surface that is seen at (uv, depth) now. It has none if it was beside the screen.
AccumulationHistory HistoryOf(float2 uv, float depth, float slope)
{
    const float4 before = mul(_PenumbraToPreviousScreen[SLICE_ARRAY_INDEX], float4(uv, depth, 1.0));
    const bool isBefore = before.w > 0.0;
    const float3 place = isBefore ? before.xyz / before.w : float3(0.0, 0.0, 0.0);
    const float2 pixel = place.xy * _PenumbraScreenSize.xy - 0.5;
    uint words[4] = { 0u, 0u, 0u, 0u };
    UNITY_BRANCH
    if (isBefore && all(place.xy > 0.0) && all(place.xy < 1.0))
    {
        const int2 last = int2(_PenumbraScreenSize.xy) - 1;
        UNITY_UNROLL
        for (int i = 0; i < 4; ++i)
            words[i] = LOAD_HISTORY(min(max(int2(floor(pixel)) + int2(i & 1, i >> 1), 0), last));
    }
    return HistoryBetween(words, frac(pixel), DepthFromFarPlane(place.z), slope);
}

AccumulateTargets Accumulate(ScreenVaryings input)
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const int2 pixel = int2(input.positionCS.xy);
    const float depth = LOAD_TEXTURE2D_X(_CameraDepthTexture, pixel).x;
    const float slope = abs(ddx(depth)) + abs(ddy(depth));
    const float here = SourceAt(pixel);
    float around[ACCUMULATION_TAPS];
    UNITY_UNROLL
    for (int i = 0; i < ACCUMULATION_TAPS; ++i) around[i] = SourceAt(pixel + AccumulationOffset(i));
    const AccumulationSurrounds surrounds = SurroundsOf(here, around);
    AccumulateTargets targets;
    targets.visibility = here;
    targets.history = 0u;
    UNITY_BRANCH
    if (!surrounds.isUniform && IsSurfaceDepth(depth))
    {
        const float2 uv = (float2(pixel) + 0.5) * _PenumbraScreenSize.zw;
        const Accumulated result =
            AccumulateFrame(here, DepthFromFarPlane(depth), HistoryOf(uv, depth, slope), surrounds);
        targets.visibility = result.visibility;
        targets.history = PackAccumulated(result);
    }
    return targets;
}

#endif
