// Penumbra: the sun's shadows of Unity's HDRP, for custom passes and your own shaders.
//
//   #pragma multi_compile_local _ _PENUMBRA_TENT_3X3 _PENUMBRA_TENT_7X7 _PENUMBRA_PCSS _PENUMBRA_PCSS_HDRP
//   // HDRP's CustomPassCommon.hlsl, or another file of HDRP that includes its ShaderVariables.hlsl; then
//   #include "Packages/com.penumbra.shadows/ShaderLibrary/Pipelines/Hdrp.hlsl"
//   ...
//   float visibility = PenumbraHdrpVisibility(posInput.positionWS, normalWS, posInput.positionSS);
//
// Computes:   cascade, shadow coordinate, receiver plane, tile scales and HDRP's PCSS parameters of a position, from
//             what HDRP uploads for the directional light that casts shadows; and its visibility with the technique
//             that the keyword selects (TechniqueByKeyword.hlsl).
// Source:     the layout of HDRP 14 to 17. The light's view as three rows, its device projection (depth 0..1) as m00,
//             m11, m22, m23, so that |m00| / 2 is tile UV per metre and |m22| depth per metre. HDRP's scale of depth
//             to radius is |m00 / m22|, twice the geometric one: tiles here carry the geometric scale, and
//             Filters/Peers/PcssHdrp.hlsl doubles it.
// Inputs:     positionRWS: in HDRP's own space, relative to the camera unless the project disabled that, metres, as
//             GetPositionInput returns it; normalWS: geometric, unit; pixel: screen coordinate. HDRP's globals; and
//             _PenumbraMainLightParams           y tan(angularDiameter / 2), z frame index of the noise
//             and those of TechniqueByKeyword.hlsl.
//             PENUMBRA_HDRP_PACKED_PCSS: 1 where HDShadowData holds dirLightPCSSParams0 and 1 (HDRP 17, Unity 6),
//             else 0; derived from Unity's version unless defined before. If it is 1 and HDRP filled them
//             (directional shadows of High quality), the light's angular diameter and all parameters of
//             _PENUMBRA_PCSS_HDRP are HDRP's own.
// Cost:       the technique's fetches; none outside all cascades. One cascade per pixel: where two blend,
//             noise selects one, as HDRP does at low and medium quality.
// Guarantees: [0, 1]; 1 without a shadowed sun and outside all cascades. The light's shadow dimmer, the last cascade's
//             fade and HDRP's normal bias are applied; shadow tint and shadow mask are not.
// Use it:     where HDRP's shadow maps exist: in lit passes, and in custom passes at BeforePreRefraction or
//             BeforeTransparent. If HDRP's HDShadowContext.hlsl is included too, include this file after it. Not: for
//             point, spot and area lights.
#ifndef PENUMBRA_HDRP_HLSL
#define PENUMBRA_HDRP_HLSL

#if !defined(UNITY_SHADER_VARIABLES_INCLUDED)
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/ShaderLibrary/ShaderVariables.hlsl"
#endif
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/Lighting/Shadow/HDShadowManager.cs.hlsl"

#include "TechniqueByKeyword.hlsl"
#include "../Core/DepthConvention.hlsl"
#include "../Core/Noise.hlsl"
#include "../Core/ReceiverPlane.hlsl"

#if !defined(PENUMBRA_HDRP_PACKED_PCSS)
#if defined(MAX_SHADOW_CASCADES) || (defined(UNITY_VERSION) && UNITY_VERSION >= 600000)
#define PENUMBRA_HDRP_PACKED_PCSS 1
#else
#define PENUMBRA_HDRP_PACKED_PCSS 0
#endif
#endif

// Versions after 17.0 name the length of HDRP's arrays; before, the length is 4.
#if defined(MAX_SHADOW_CASCADES)
#define PENUMBRA_HDRP_CASCADES MAX_SHADOW_CASCADES
#else
#define PENUMBRA_HDRP_CASCADES 4
#endif

#if !defined(HD_SHADOW_CONTEXT_HLSL)
TEXTURE2D(_ShadowmapCascadeAtlas);
StructuredBuffer<HDShadowData> _HDShadowDatas;
StructuredBuffer<HDDirectionalShadowData> _HDDirectionalShadowData;
#endif

// Unity creates inline samplers from the words in these names.
SAMPLER_CMP(sampler_PenumbraLinearClampCompare);
SAMPLER(sampler_PenumbraPointClamp);

float4 _PenumbraMainLightParams;

// HDRP adds this bias to every reference depth: its casters have a slope-scaled bias, and this is the small constant
// part.
static const float kHdrpDepthBias = 1.0 / 65536.0;

struct PenumbraHdrpCascade
{
    int index;   // -1: no cascade contains the position
    float blend; // how far into the border to the next cascade, 0 to 1
};

struct PenumbraHdrpLight
{
    bool covered;   // false: no map covers the position, it is lit
    int cascade;
    float strength; // the shadow's strength: the light's dimmer, reduced where the last cascade fades out
    ShadowReceiver receiver;
    ShadowTile tile;
    PcssHdrpParameters pcss;
};

// The first sphere that contains the position (spheres hold squared radii). The border blends on the far side only:
// where the sphere's centre lies behind the position as seen from the camera, HDRP removes the blend by a steep ramp.
PenumbraHdrpCascade PenumbraHdrpCascadeOf(float3 positionRWS, HDDirectionalShadowData shadows, int count)
{
    PenumbraHdrpCascade cascade;
    cascade.index = -1;
    cascade.blend = 0.0;
    UNITY_LOOP
    for (int i = 0; i < count && cascade.index < 0; ++i)
    {
        const float3 fromCentre = positionRWS - shadows.sphereCascades[i].xyz;
        const float squaredDistance = dot(fromCentre, fromCentre);
        const float squaredRadius = shadows.sphereCascades[i].w;
        if (squaredDistance < squaredRadius)
        {
            const float border = shadows.cascadeBorders[i];
            const float inside = 1.0 - squaredDistance / squaredRadius;
            const float3 outward = fromCentre * rsqrt(max(squaredDistance, 1e-20));
            const float facing = dot(GetWorldSpaceViewDir(positionRWS), outward);
            const float steepness = 8.0 + 512.0 * smoothstep(1.0, 0.7, border);
            cascade.index = i;
            cascade.blend = border > 0.0 ? max(1.0 - inside / border, 0.0) : 0.0;
            cascade.blend *= 1.0 - min(max(facing * steepness, 0.0), 1.0);
        }
    }
    return cascade;
}

// Maps positions in HDRP's space to atlas UV and stored depth.
float4x4 PenumbraHdrpWorldToAtlas(HDShadowData data)
{
    const float2 extent = data.shadowMapSize.xy * _CascadeShadowAtlasSize.zw;
    const float2 scale = 0.5 * data.proj.xy * extent;
    const float2 centre = data.atlasOffset + 0.5 * extent;
    return float4x4(float4(data.rot0, data.pos.x) * scale.x + float4(0.0, 0.0, 0.0, centre.x),
                    float4(data.rot1, data.pos.y) * scale.y + float4(0.0, 0.0, 0.0, centre.y),
                    float4(data.rot2, data.pos.z) * data.proj.z + float4(0.0, 0.0, 0.0, data.proj.w),
                    float4(0.0, 0.0, 0.0, 1.0));
}

bool PenumbraHdrpIsPacked(HDShadowData data)
{
#if PENUMBRA_HDRP_PACKED_PCSS
    // HDRP fills these parameters at High quality only. For a light without a disc the first two hold 0 and an
    // infinity.
    return data.dirLightPCSSParams1.y > 0.0;
#else
    return false;
#endif
}

// tanHalf is the light's, and is used where HDRP did not pack its own.
ShadowTile PenumbraHdrpTile(HDShadowData data, float tanHalf)
{
    ShadowTile tile;
    tile.offsetScale = float4(data.atlasOffset, data.shadowMapSize.xy * _CascadeShadowAtlasSize.zw);
    tile.atlasTexelSize = _CascadeShadowAtlasSize.zwxy;
    tile.uvPerMetre = 0.5 * abs(data.proj.x) * length(data.rot0);
    tile.depthPerMetre = abs(data.proj.z) * length(data.rot2);
    tile.depthToRadial = tanHalf * tile.uvPerMetre / max(tile.depthPerMetre, 1e-20);
#if PENUMBRA_HDRP_PACKED_PCSS
    if (PenumbraHdrpIsPacked(data)) tile.depthToRadial = 0.5 * data.dirLightPCSSParams0.x;
#endif
    tile.radialToDepth = tile.depthToRadial > 0.0 ? 1.0 / tile.depthToRadial : 0.0;
    return tile;
}

// How HDRP packs the light's settings: with s = |m00 / m22| and t = tan(a/2)
//   dirLightPCSSParams0   t s | 1 / (t s) | widest penumbra / (2 t), metres | cone height, metres
//   dirLightPCSSParams1   smallest filter, texels | 1 / (s tan) of its cone | 1 / (s tan) of the search's | clump / 2
//   shadowFilterParams0   y blocker samples, z filter samples: integers by their bits
PcssHdrpParameters PenumbraHdrpParametersOf(HDShadowData data)
{
    PcssHdrpParameters parameters = PenumbraPcssHdrp();
#if PENUMBRA_HDRP_PACKED_PCSS
    if (PenumbraHdrpIsPacked(data))
    {
        const float radialPerDepth = abs(data.proj.x) / max(abs(data.proj.z), 1e-20);
        const float tanHalf = data.dirLightPCSSParams0.x / max(radialPerDepth, 1e-20);
        parameters.blockerSamples = asint(data.shadowFilterParams0.y);
        parameters.filterSamples = asint(data.shadowFilterParams0.z);
        parameters.blockerClump = 2.0 * data.dirLightPCSSParams1.w;
        parameters.minFilterTexels = data.dirLightPCSSParams1.x;
        parameters.maxPenumbraMetres = tanHalf > 0.0 ? 2.0 * tanHalf * data.dirLightPCSSParams0.z : 0.0;
        parameters.maxSamplingMetres = data.dirLightPCSSParams0.w;
        parameters.minFilterTanHalf = 1.0 / (data.dirLightPCSSParams1.y * radialPerDepth);
        parameters.searchTanHalf = 1.0 / (data.dirLightPCSSParams1.z * radialPerDepth);
    }
#endif
    return parameters;
}

ShadowReceiver PenumbraHdrpReceiver(float3 positionRWS, float3 normalWS, HDShadowData data, float2 rotation)
{
    const float4x4 worldToAtlas = PenumbraHdrpWorldToAtlas(data);
    // Cached maps may be older than the camera's position, and the normal bias is HDRP's, which moves the receiver.
    const float3 moved = positionRWS + data.cacheTranslationDelta + normalWS * (data.normalBias * data.worldTexelSize);
    ShadowReceiver receiver;
    receiver.shadowCoord = mul(worldToAtlas, float4(moved, 1.0)).xyz;
    receiver.shadowCoord.z = MoveTowardLight(receiver.shadowCoord.z, kHdrpDepthBias);
    receiver.depthGradient = ReceiverPlaneFromNormal(normalWS, worldToAtlas);
    receiver.rotation = rotation;
    return receiver;
}

// normalWS is the surface's own (not normal-mapped) normal, unit, or 0 where it is not known. pixel is a pixel of the
// screen.
PenumbraHdrpLight PreparePenumbraHdrpLight(float3 positionRWS, float3 normalWS, float2 pixel)
{
    PenumbraHdrpLight light = (PenumbraHdrpLight)0;
    if (_DirectionalShadowIndex < 0) return light;
    const DirectionalLightData sun = _DirectionalLightDatas[_DirectionalShadowIndex];
    const HDDirectionalShadowData shadows = _HDDirectionalShadowData[0];
    const int count = min(int(_CascadeShadowCount), PENUMBRA_HDRP_CASCADES);
    const PenumbraHdrpCascade cascade = PenumbraHdrpCascadeOf(positionRWS, shadows, count);
    if (sun.shadowIndex < 0 || cascade.index < 0) return light;

    const int last = min(int(shadows.cascadeDirection.w), count) - 1;
    const float noise = GradientNoise(pixel, uint(max(_PenumbraMainLightParams.z, 0.0)));
    const bool next = cascade.index < last && cascade.blend > noise;
    light.cascade = cascade.index + (next ? 1 : 0);
    const HDShadowData data = _HDShadowDatas[sun.shadowIndex + light.cascade];
    const float3 towardLight = dot(normalWS, sun.forward) > 0.0 ? -normalWS : normalWS;

    light.covered = abs(data.proj.x) > 0.0 && abs(data.proj.z) > 0.0 && data.shadowMapSize.x > 0.0;
    light.strength = sun.shadowDimmer * (cascade.index < last ? 1.0 : 1.0 - cascade.blend);
    light.receiver = PenumbraHdrpReceiver(positionRWS, towardLight, data, RotationFromNoise(noise));
    light.tile = PenumbraHdrpTile(data, _PenumbraMainLightParams.y);
    light.pcss = PenumbraHdrpParametersOf(data);
    return light;
}

float PenumbraHdrpVisibility(float3 positionRWS, float3 normalWS, float2 pixel)
{
    const PenumbraHdrpLight light = PreparePenumbraHdrpLight(positionRWS, normalWS, pixel);
    if (!light.covered) return 1.0;
#if defined(PENUMBRA_USES_PCSS_HDRP)
    const float visibility =
        FilterPcssHdrp(TEXTURE2D_SHADOW_ARGS(_ShadowmapCascadeAtlas, sampler_PenumbraLinearClampCompare),
                       sampler_PenumbraPointClamp, light.receiver, light.tile, light.pcss);
#else
    const float visibility =
        FilterByKeyword(TEXTURE2D_SHADOW_ARGS(_ShadowmapCascadeAtlas, sampler_PenumbraLinearClampCompare),
                        sampler_PenumbraPointClamp, light.receiver, light.tile, light.cascade);
#endif
    return 1.0 + light.strength * (visibility - 1.0);
}

#endif
