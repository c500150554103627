// Penumbra: PCF that hardens at contacts (DPCF) by the rules of Filament, for comparison.
//
// Computes:   the share of blockers on a disk as wide as Filament's bulb, made harder where the blockers are near: the
//             taps of the search are the filter's, too.
// Source:     Myers, "Shadow of Cold War" (2021), as Filament's ShadowType DPCF has it (FilamentTaps.hlsl): 12 taps,
//             and the hardened share s of x is 1/2 + (s' - s' (1 - |2x - 1|)^3) / 2 with s' the sign of 2x - 1.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; ShadowReceiver; ShadowTile;
//             FilamentParameters, of which filterSamples is not used.
// Cost:       blockerSamples fetches.
// Guarantees: [0, 1] for any input; exactly 1 without blockers; exactly 0 below a wall that is above the receiver's
//             plane at every tap (the plane of a surface along the light's rays passes the near plane); texels outside
//             the tile are not read.
// Use it:     for comparison with Filament, whose parameters FilamentTaps.hlsl explains; the renderer feature does not
//             offer it. Not: as a first choice.
#ifndef PENUMBRA_FILAMENT_DPCF_HLSL
#define PENUMBRA_FILAMENT_DPCF_HLSL

#include "FilamentTaps.hlsl"

float FilamentHardened(float share)
{
    const float x = 2.0 * share - 1.0;
    const float toEnd = 1.0 - abs(x);
    return 0.5 + 0.5 * sign(x) * (1.0 - toEnd * toEnd * toEnd);
}

float FilterFilamentDpcf(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                         ShadowReceiver receiver, ShadowTile tile, FilamentParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const QuadReceiver prepared = FilamentReceiver(receiver, tile, scales, parameters);
    const int count = FilamentCount(parameters.blockerSamples);
    const FilamentBlockers blockers =
        FilamentSearch(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, UnitRotation(receiver.rotation),
                       FilamentBulbRadius(scales, parameters), count);
    if (!(blockers.heightSum > 0.0)) return 1.0;
    if (blockers.count >= float(count)) return 0.0;

    const float ratio = min(max(FilamentPenumbraRatio(prepared, blockers.heightSum / blockers.count), 0.0), 1.0);
    const float share = blockers.count / float(count);
    return SanitizeVisibility(1.0 - lerp(FilamentHardened(share), share, ratio));
}

#endif
