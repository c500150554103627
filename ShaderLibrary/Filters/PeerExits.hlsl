// Penumbra: what the filters by other engines' rules read, for exits before them.
//
// Computes:   ExitReach of Godot's PCSS, of Filament's PCSS and DPCF, and of Unreal's rays.
// Source:     GodotPcss.hlsl, FilamentPcss.hlsl, FilamentDpcf.hlsl, UnrealSmrt.hlsl.
// Inputs:     those of the filters.
// Cost:       no fetches.
// Guarantees: those of FilterExits.hlsl. Unreal's rays are never called dark: what they hit behind a caster is a surface
//             that they continue by its slope, of which planes say nothing.
// Use it:     with DecideExits.
#ifndef PENUMBRA_PEER_EXITS_HLSL
#define PENUMBRA_PEER_EXITS_HLSL

#include "FilterExits.hlsl"
#include "GodotPcss.hlsl"
#include "FilamentTaps.hlsl"
#include "UnrealSmrt.hlsl"

// Beyond any height of a map.
static const float kAnyHeight = 2.0;

// A filter whose radius is that of the search, times (d_receiver - d_blocker) / d_blocker, distances from the near plane.
ExitReach WithRadiusOfRatio(ExitReach before, float searchRadius, ConeScales scales)
{
    const float distance = max(LargestGap(before.receiver.depth), 1e-7);
    ExitReach reach = before;
    reach.radiusPerGap = searchRadius / distance;
    reach.inverseDistance = 1.0 / distance;
    reach.largestRadius = scales.largestRadius;
    return reach;
}

ExitReach ReachOfGodotPcss(ShadowReceiver receiver, ShadowTile tile, GodotPcssParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const QuadReceiver prepared = GodotReceiver(receiver, tile, scales, parameters);
    const float search = GodotSearchRadius(prepared, scales, parameters);
    return WithRadiusOfRatio(FlatReachOfDisc(prepared, search + kSampleReachTexels), search, scales);
}

// Its taps are compared with the plane alone, also beyond the tile, where they take the texels of its edge.
ExitReach FilamentReach(ShadowReceiver receiver, ShadowTile tile, ConeScales scales, FilamentParameters parameters)
{
    const QuadReceiver prepared = FilamentReceiver(receiver, tile, scales, parameters);
    ExitReach reach = ReachOfDisc(prepared, FilamentBulbRadius(scales, parameters) + kSampleReachTexels);
    reach.planeShift = kFootprintShift;
    reach.planeAlone = true;
    reach.insideAlone = true;
    return reach;
}

ExitReach ReachOfFilamentDpcf(ShadowReceiver receiver, ShadowTile tile, FilamentParameters parameters)
{
    return FilamentReach(receiver, tile, ConeScalesOf(tile), parameters);
}

ExitReach ReachOfFilamentPcss(ShadowReceiver receiver, ShadowTile tile, FilamentParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    return WithRadiusOfRatio(FilamentReach(receiver, tile, scales, parameters), FilamentBulbRadius(scales, parameters),
                             scales);
}

// A ray is above the receiver by the radius of the cone there, and hits nothing where no texel is above it.
ExitReach ReachOfUnrealSmrt(ShadowReceiver receiver, ShadowTile tile, UnrealSmrtParameters parameters)
{
    const ConeScales scales = ConeScalesOf(tile);
    const SmrtBase base = SmrtBaseOf(receiver, tile, scales, parameters);
    const float slack = 0.7072 * base.dither + 0.1;
    ExitReach reach = FlatReachOfDisc(base.receiver, base.rise * scales.texelsPerDepth + slack + kSampleReachTexels);
    reach.slackTexels = slack;
    reach.depthPerTexel = scales.depthPerTexel;
    reach.largestOffset = kAnyHeight;
    reach.mayBeDark = false;
    return reach;
}

#endif
