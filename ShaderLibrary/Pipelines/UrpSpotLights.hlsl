// Penumbra: the shadow data of URP's additional spot lights, in the form that filters take.
//
// Computes:   shadow coordinate, receiver plane and slice of a world position under one of URP's additional lights,
//             from the globals that URP uploads.
// Source:     the layout of URP 12 to 17. _AdditionalShadowParams of a light: x strength, z 0 for a spot light and 1
//             for a point light, w the index of its slice, below 0 without a shadow. _AdditionalLightsWorldToShadow of
//             a slice takes world space to atlas UV and stored depth, times w. Both are arrays, or structured buffers
//             whose names end in _SSBO. URP uploads neither the slice's place nor its planes nor the cone: the first
//             two follow from the matrix (Core/SpotLight.hlsl), the cone from the light's attenuation, whose z and w
//             are 1 / (cos inner - cos outer) and -cos outer times that.
// Inputs:     URP's globals; _AdditionalLightsShadowmapTexture_TexelSize, which Unity sets; the frame index in
//             _PenumbraMainLightParams.z.
// Cost:       no fetches.
// Guarantees: a position that the light's map does not cover, and a light without a shadow map or of another type, are
//             reported as not covered.
// Use it:     through SpotShadows.hlsl, which tells when there is something to read.
#ifndef PENUMBRA_URP_SPOT_LIGHTS_HLSL
#define PENUMBRA_URP_SPOT_LIGHTS_HLSL

#include "Urp.hlsl"
#include "../Core/SpotLight.hlsl"

float4 _AdditionalLightsShadowmapTexture_TexelSize; // 1/width, 1/height, width, height

struct PenumbraSpotLight
{
    bool covered; // false: no map covers the position, it is lit
    float strength;
    SpotMap map;
    ShadowReceiver receiver;
    ShadowTile tile;
};

float4x4 PenumbraSpotLightMatrix(int slice)
{
#if USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA
    return _AdditionalLightsWorldToShadow_SSBO[slice];
#else
    return _AdditionalLightsWorldToShadow[slice];
#endif
}

float4 PenumbraSpotLightAttenuation(int lightIndex)
{
#if USE_STRUCTURED_BUFFER_FOR_LIGHT_DATA
    return _AdditionalLightsBuffer[lightIndex].attenuation;
#else
    return _AdditionalLightsAttenuation[lightIndex];
#endif
}

// The tangent of half the cone's full angle.
float PenumbraSpotLightTanHalf(int lightIndex)
{
    const float4 attenuation = PenumbraSpotLightAttenuation(lightIndex);
    const float cosine = min(max(-attenuation.w / max(attenuation.z, 1e-6), 1e-3), 1.0);
    return sqrt(1.0 - cosine * cosine) / cosine;
}

// lightIndex counts in URP's list of visible lights, as for PenumbraAdditionalLightVisibility.
PenumbraSpotLight PreparePenumbraSpotLight(int lightIndex, float3 positionWS, float3 normalWS, float2 pixel,
                                           float sourceRadiusMetres)
{
    const float4 params = GetAdditionalLightShadowParams(lightIndex);
    const float4x4 worldToShadow = PenumbraSpotLightMatrix(int(max(params.w, 0.0)));

    PenumbraSpotLight shadow;
    shadow.strength = params.x;
    shadow.tile.atlasTexelSize = _AdditionalLightsShadowmapTexture_TexelSize;
    shadow.tile.offsetScale =
        SliceOfSpotMap(worldToShadow, PenumbraSpotLightTanHalf(lightIndex), shadow.tile.atlasTexelSize);
    shadow.map = SpotMapOfMatrix(worldToShadow, shadow.tile.offsetScale, sourceRadiusMetres);

    const SpotCoordinate coordinate = ProjectOntoSpotMap(positionWS, worldToShadow, shadow.tile.offsetScale);
    shadow.covered = coordinate.covered && params.w >= 0.0 && params.z < 0.5;
    shadow.receiver.shadowCoord = coordinate.shadowCoord;
    shadow.receiver.depthGradient = ReceiverPlaneInPerspective(normalWS, worldToShadow, coordinate.shadowCoord);
    shadow.receiver.rotation = DiskRotation(pixel, uint(max(_PenumbraMainLightParams.z, 0.0)));
    shadow.tile = TileAtReceiver(shadow.tile, shadow.map, coordinate.axialMetres);
    return shadow;
}

#endif
