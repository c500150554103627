// Penumbra: percentage-closer soft shadows of a spot light with a source of a given radius.
//
// Computes:   visibility of a disc around the light's position that faces the receiver: mean gap of the blockers
//             between receiver and disc, then the lit share of a disc as wide as the penumbra that gap makes.
// Source:     Fernando, "Percentage-Closer Soft Shadows" (2005), for a light in perspective. In the map, straight lines
//             stay straight and 1 / depth is linear (Core/SpotLight.hlsl), so blockers are searched and weighed as
//             under the sun, by PcssAngular.hlsl, with these scales: - penumbra radius in tile UV: R (f - n) / (2
//             tan(angle / 2) n f) per unit of stored depth gap. The mean of
//               stored gaps is the mean of the penumbra's radii; a mean of depths in metres would not be.
//             - search: as far as a blocker on the near plane hides part of the disc. It has as many samples in every
//               octave of radius, because that is far where the near plane is close to the light.
//             - kernels are ellipses away from the axis, because the map's plane does not face the receiver.
// Inputs:     shadow map (raw reads; the comparison sampler is not used), point sampler; SpotMap: planes, angle,
//             source; ShadowReceiver: after division by w, its gradient from ReceiverPlaneInPerspective; ShadowTile: of
//             its fields the rectangle and the atlas size; PcssSpotParameters.
// Cost:       as PcssAngular.hlsl: blockerSamples fetches where nothing blocks, else 4 more where the penumbra is
//             narrow and filterSamples more where it is wide, and 4 more there where a low blocker stands, too.
// Guarantees: [0, 1] for any input; exactly 1 without blockers, exactly 0 where every texel read blocks; texels outside
//             the tile are not read.
// Use it:     for receivers that ProjectOntoSpotMap() calls covered. Not: on devices without gather, and not for point
//             lights, whose blockers lie in several tiles.
#ifndef PENUMBRA_PCSS_SPOT_HLSL
#define PENUMBRA_PCSS_SPOT_HLSL

#include "PcssAngular.hlsl"
#include "Parameters/PcssSpotParameters.hlsl"

QuadReceiver PrepareQuadsInPerspective(ShadowReceiver receiver, ShadowTile tile, SpotMap light)
{
    QuadReceiver prepared = PrepareQuads(receiver, tile);
    const float2 extent = max(prepared.bounds.maximum - prepared.bounds.minimum, 1.0);
    prepared.inPerspective = true;
    prepared.awayFromAxis = AwayFromAxis((prepared.centre - prepared.bounds.minimum) / extent, light);
    return prepared;
}

// The cone has no height of its own to end at, since it is as high as the light.
PcssAngularParameters AngularOfSpot(PcssSpotParameters parameters)
{
    PcssAngularParameters angular;
    angular.blockerSamples = parameters.blockerSamples;
    angular.filterSamples = parameters.filterSamples;
    angular.blockerClump = 0.0;
    angular.minFilterTexels = parameters.minFilterTexels;
    angular.maxPenumbraMetres = parameters.maxPenumbraMetres;
    angular.maxSamplingMetres = 1e6;
    return angular;
}

float FilterPcssSpot(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point), SpotMap light,
                     ShadowReceiver receiver, ShadowTile tile, PcssSpotParameters parameters)
{
    const QuadReceiver prepared = PrepareQuadsInPerspective(receiver, tile, light);
    const ShadowTile scaled = TileAtReceiver(tile, light, AxialDepth(prepared.depth, light));
    const AngularSearch search =
        SearchAround(TEXTURE2D_ARGS(shadowMap, sampler_point), prepared, UnitRotation(receiver.rotation),
                     ConeScalesOf(scaled), AngularOfSpot(parameters));
    return FilterFound(TEXTURE2D_ARGS(shadowMap, sampler_point), search, parameters.filterSamples);
}

#endif
