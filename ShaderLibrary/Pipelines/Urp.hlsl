// Penumbra: the main light's shadow data of Unity's URP, in the form that filters take.
//
// Computes:   cascade, shadow coordinate, receiver plane and tile scales of a world position, from the globals that URP
//             uploads every frame.
// Source:     the layout of URP 14 to 17: atlas tiles two by two, the atlas half as high with two cascades; matrices
//             that map world space to atlas UV and stored depth. From M: |row0.xyz| is atlas UV per metre, |row2.xyz|
//             depth per metre.
// Inputs:     URP's globals; and ours, set from C# because URP does not always set its own:
//             _PenumbraMainLightAtlasTexelSize   1/width, 1/height, width, height
//             _PenumbraMainLightParams           x cascade count, y tan(angularDiameter / 2), z frame index,
//                                                w border between cascades, share of a split sphere's radius, 0 none
// Cost:       no fetches.
// Guarantees: the only file that names a pipeline's globals. A position beyond the shadow distance, in front of or
//             behind the map's depth range, or in a cascade for which URP set no matrix, is reported as not covered.
// Use it:     through Shadows.hlsl. Not: for additional lights.
#ifndef PENUMBRA_URP_HLSL
#define PENUMBRA_URP_HLSL

#if !defined(UNIVERSAL_SHADOWS_INCLUDED)
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
// URP's Shadows.hlsl calls LerpWhiteTo, which the including file must provide.
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"
#endif

#include "../Core/CascadeSelection.hlsl"
#include "../Core/Noise.hlsl"
#include "../Core/ReceiverPlane.hlsl"
#include "../Core/ShadowStructs.hlsl"

// Unity creates inline samplers from the words in these names.
SAMPLER_CMP(sampler_PenumbraLinearClampCompare);
SAMPLER(sampler_PenumbraPointClamp);

float4 _PenumbraMainLightAtlasTexelSize;
float4 _PenumbraMainLightParams;

struct PenumbraMainLight
{
    bool covered; // false: no map covers the position, it is lit
    int cascade;
    ShadowReceiver receiver;
    ShadowTile tile;
};

CascadeSpheres PenumbraMainLightSpheres()
{
    CascadeSpheres spheres;
    spheres.centre0 = _CascadeShadowSplitSpheres0.xyz;
    spheres.centre1 = _CascadeShadowSplitSpheres1.xyz;
    spheres.centre2 = _CascadeShadowSplitSpheres2.xyz;
    spheres.centre3 = _CascadeShadowSplitSpheres3.xyz;
    spheres.squaredRadii = _CascadeShadowSplitSphereRadii;
    return spheres;
}

int PenumbraMainLightCascade(float3 positionWS, int count)
{
    // With one cascade URP leaves the spheres of an earlier frame in place.
    if (count <= 1) return 0;
    return SelectCascade(positionWS, PenumbraMainLightSpheres(), count);
}

int PenumbraMainLightCascadeCount()
{
    return min(max(int(_PenumbraMainLightParams.x), 1), 4);
}

// Maps world metres to atlas UV and stored depth, for a cascade of 0 .. count - 1.
float4x4 PenumbraMainLightMatrix(int cascade)
{
    return _MainLightWorldToShadow[cascade];
}

// Whether filters read the next cascade at some pixels near this position, which lies in `cascade`.
bool PenumbraMainLightInBorder(float3 positionWS, int cascade)
{
    const float border = _PenumbraMainLightParams.w;
    if (!(border > 0.0)) return false;
    return NextCascadeWeight(positionWS, PenumbraMainLightSpheres(), cascade, PenumbraMainLightCascadeCount(),
                             border) > 0.0;
}

// In the border to the next cascade, noise chooses either of both.
int PenumbraMainLightDitheredCascade(float3 positionWS, int count, float2 pixel)
{
    const int cascade = PenumbraMainLightCascade(positionWS, count);
    const float border = _PenumbraMainLightParams.w;
    int chosen = cascade;
    UNITY_BRANCH
    if (border > 0.0)
    {
        const float weight = NextCascadeWeight(positionWS, PenumbraMainLightSpheres(), cascade, count, border);
        if (weight > CascadeNoise(pixel, uint(max(_PenumbraMainLightParams.z, 0.0)))) chosen = cascade + 1;
    }
    return chosen;
}

ShadowTile PenumbraMainLightTile(float4x4 worldToShadow, int cascade, int count, float tanHalf)
{
    const float2 extent = float2(count > 1 ? 0.5 : 1.0, count > 2 ? 0.5 : 1.0);
    const float uvPerMetre = length(worldToShadow[0].xyz) / extent.x;
    const float depthPerMetre = length(worldToShadow[2].xyz);
    ShadowTile tile;
    tile.offsetScale = float4(float2(cascade & 1, cascade >> 1) * extent, extent);
    tile.atlasTexelSize = _PenumbraMainLightAtlasTexelSize;
    tile.uvPerMetre = uvPerMetre;
    tile.depthPerMetre = depthPerMetre;
    tile.depthToRadial = tanHalf * uvPerMetre / max(depthPerMetre, 1e-20);
    tile.radialToDepth = tanHalf > 0.0 ? depthPerMetre / max(tanHalf * uvPerMetre, 1e-20) : 0.0;
    return tile;
}

// Prepares the light in a cascade that PenumbraMainLightCascade returned. normalWS is the surface's own (not
// normal-mapped) normal, unit, or 0 where it is not known. pixel is a pixel of the screen, and rotates the disk.
PenumbraMainLight PreparePenumbraMainLightIn(int cascade, float3 positionWS, float3 normalWS, float2 pixel)
{
    const int count = PenumbraMainLightCascadeCount();
    const float4x4 worldToShadow = _MainLightWorldToShadow[min(cascade, count - 1)];
    const float3 shadowCoord = mul(worldToShadow, float4(positionWS, 1.0)).xyz;

    PenumbraMainLight shadow;
    // URP fills the slots of missing cascades with a matrix that maps everything to one point.
    const bool mapped = dot(worldToShadow[0].xyz, worldToShadow[0].xyz) > 0.0;
    shadow.covered = cascade < count && mapped && shadowCoord.z > 0.0 && shadowCoord.z < 1.0;
    shadow.cascade = min(cascade, count - 1);
    shadow.receiver.shadowCoord = shadowCoord;
    shadow.receiver.depthGradient = ReceiverPlaneFromNormal(normalWS, worldToShadow);
    shadow.receiver.rotation = DiskRotation(pixel, uint(max(_PenumbraMainLightParams.z, 0.0)));
    shadow.tile = PenumbraMainLightTile(worldToShadow, shadow.cascade, count, _PenumbraMainLightParams.y);
    return shadow;
}

// Prepares the light for a filter, whose noise also chooses the cascade in a border.
PenumbraMainLight PreparePenumbraMainLight(float3 positionWS, float3 normalWS, float2 pixel)
{
    const int cascade = PenumbraMainLightDitheredCascade(positionWS, PenumbraMainLightCascadeCount(), pixel);
    return PreparePenumbraMainLightIn(cascade, positionWS, normalWS, pixel);
}

// Prepares the light for single comparisons, away from penumbrae or in search of them.
PenumbraMainLight PreparePenumbraMainLightTap(float3 positionWS, float3 normalWS)
{
    const int cascade = PenumbraMainLightCascade(positionWS, PenumbraMainLightCascadeCount());
    return PreparePenumbraMainLightIn(cascade, positionWS, normalWS, float2(0.0, 0.0));
}

// URP's shadow strength is applied: a strength of 0 leaves everything lit.
float ApplyPenumbraStrength(float visibility)
{
    return 1.0 + _MainLightShadowParams.x * (visibility - 1.0);
}

#endif
