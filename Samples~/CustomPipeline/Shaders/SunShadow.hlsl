// Custom pipeline sample: the sun's visibility, by a filter of the library with this pipeline's own uniforms.
//
// Computes:   visibility of the sun at a world position. This is all that another pipeline has to write: select a
//             cascade, fill ShadowReceiver and ShadowTile, call a filter.
// Inputs:     positionWS, metres; normalWS: the geometric normal, unit; pixel: screen position. SunUniforms.cs sets
//             the uniforms.
// Cost:       that of FilterPcssAngular: the blocker samples, and in a penumbra also the filter samples.
// Guarantees: [0, 1]; 1 beyond the last cascade, and in a cascade that was not drawn.
#ifndef PENUMBRA_SAMPLE_SUN_SHADOW_HLSL
#define PENUMBRA_SAMPLE_SUN_SHADOW_HLSL

#include "PipelineInput.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/CascadeSelection.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/Noise.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/ReceiverPlane.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Filters/Pcss/PcssAngular.hlsl"

TEXTURE2D_SHADOW(_SunShadowMap);

// Unity creates inline samplers from the words in these names.
SAMPLER_CMP(sampler_SunLinearClampCompare);
SAMPLER(sampler_SunPointClamp);

float4x4 _SunWorldToShadow[4]; // world space to atlas UV and stored depth
float4 _SunSpheres[4];         // xyz: centre, world space; w: squared radius, 0 where the cascade was not drawn
float4 _SunTiles[4];           // xy: origin, zw: extent, in atlas UV
float4 _SunScales[4];          // uvPerMetre, depthPerMetre, depthToRadial, radialToDepth of ShadowTile
float4 _SunAtlasTexelSize;     // 1/width, 1/height, width, height
float4 _PenumbraPcssAngularParameters0; // packed by the library's PcssAngularParameters.cs
float4 _PenumbraPcssAngularParameters1;
float4 _SunCascades;           // x: count, 0 without a shadow map; y: frame index of the noise

CascadeSpheres SunSpheres()
{
    CascadeSpheres spheres;
    spheres.centre0 = _SunSpheres[0].xyz;
    spheres.centre1 = _SunSpheres[1].xyz;
    spheres.centre2 = _SunSpheres[2].xyz;
    spheres.centre3 = _SunSpheres[3].xyz;
    spheres.squaredRadii = float4(_SunSpheres[0].w, _SunSpheres[1].w, _SunSpheres[2].w, _SunSpheres[3].w);
    return spheres;
}

ShadowTile SunTile(int cascade)
{
    ShadowTile tile;
    tile.offsetScale = _SunTiles[cascade];
    tile.atlasTexelSize = _SunAtlasTexelSize;
    tile.uvPerMetre = _SunScales[cascade].x;
    tile.depthPerMetre = _SunScales[cascade].y;
    tile.depthToRadial = _SunScales[cascade].z;
    tile.radialToDepth = _SunScales[cascade].w;
    return tile;
}

float SunVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const int count = int(_SunCascades.x);
    const int cascade = SelectCascade(positionWS, SunSpheres(), count);
    if (cascade >= count) return 1.0;

    const float4x4 worldToShadow = _SunWorldToShadow[cascade];
    ShadowReceiver receiver;
    receiver.shadowCoord = mul(worldToShadow, float4(positionWS, 1.0)).xyz;
    receiver.depthGradient = ReceiverPlaneFromNormal(normalWS, worldToShadow);
    receiver.rotation = DiskRotation(pixel, uint(_SunCascades.y));
    if (!(receiver.shadowCoord.z > 0.0 && receiver.shadowCoord.z < 1.0)) return 1.0;

    return FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(_SunShadowMap, sampler_SunLinearClampCompare),
                             sampler_SunPointClamp, receiver, SunTile(cascade),
                             UnpackPcssAngularParameters(_PenumbraPcssAngularParameters0,
                                                         _PenumbraPcssAngularParameters1));
}

#endif
