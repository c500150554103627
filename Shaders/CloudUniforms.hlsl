// Penumbra: the layer of clouds as the feature's passes know it.
//
// Computes:   LayerOfClouds: where the map lies.
// Source:     Core/CloudLayer.hlsl.
// Inputs:     _PenumbraTowardSun            towards the sun, world space, unit; half its angular diameter, radians
//             _PenumbraCloudCentre          the camera, world space; of two eyes the same for both
//             _PenumbraCloudWind            metres that the clouds have moved along x and z
//             _PenumbraCloudParameters0, 1  of Far/Parameters/CloudParameters.hlsl
// Cost:       no fetches.
// Guarantees: those of CloudLayerAround.
// Use it:     in the pass that fills the map, and in those that read it.
#ifndef PENUMBRA_CLOUD_UNIFORMS_HLSL
#define PENUMBRA_CLOUD_UNIFORMS_HLSL

#include "../ShaderLibrary/Core/CloudCover.hlsl"
#include "../ShaderLibrary/Core/CloudLayer.hlsl"
#include "../ShaderLibrary/Far/Parameters/CloudParameters.hlsl"

float4 _PenumbraTowardSun;
float4 _PenumbraCloudCentre;
float4 _PenumbraCloudWind;
float4 _PenumbraCloudParameters0;
float4 _PenumbraCloudParameters1;

static const float kCloudTexels = 512.0; // texels of the map's side, as its graph declares it

CloudLayer LayerOfClouds(CloudParameters parameters)
{
    return CloudLayerAround(_PenumbraCloudCentre.xyz, _PenumbraTowardSun.xyz, parameters.cloudAltitudeMetres,
                            parameters.cloudMapMetres, parameters.cloudBorder, kCloudTexels);
}

#endif
