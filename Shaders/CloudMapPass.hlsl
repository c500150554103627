// Penumbra: the map of a procedural layer of clouds.
//
// Computes:   the layer's transmittance straight up, at each texel's centre.
// Source:     Core/CloudCover.hlsl.
// Inputs:     those of ScreenPass.hlsl; _PenumbraTowardSun and _PenumbraCloudWind, of CloudUniforms.hlsl;
//             _PenumbraCloudParameters0 and 1, of Far/Parameters/CloudParameters.hlsl.
// Cost:       no fetches.
// Guarantees: [0, 1].
// Use it:     before FarPass.hlsl with _PENUMBRA_CLOUDS. Not: where the sky has clouds of its own, which can be drawn
//             into the map.
#ifndef PENUMBRA_CLOUD_MAP_PASS_HLSL
#define PENUMBRA_CLOUD_MAP_PASS_HLSL

#include "ScreenPass.hlsl"
#include "CloudUniforms.hlsl"

float4 CloudMap(ScreenVaryings input) : SV_Target
{
    const CloudParameters parameters = UnpackCloudParameters(_PenumbraCloudParameters0, _PenumbraCloudParameters1);
    const CloudLayer layer = LayerOfClouds(parameters);
    const float2 place = layer.corner + layer.size * input.positionCS.xy / kCloudTexels;
    const CloudCover cover = BoundedCloudCover(_PenumbraCloudWind.xy, parameters.cloudFeatureMetres,
                                               parameters.cloudCoverage, parameters.cloudDensity);
    return CloudTransmittance(place, cover);
}

#endif
