// Stands in for HDRP's file of this name: what its C# uploads for each cascade, and for the directional light. Names,
// types and order are HDRP's interface (14); STAND_IN_HDRP_17 adds what version 17 packs for its PCSS, and
// STAND_IN_HDRP_SIX_CASCADES what later ones allow.
#ifndef HDSHADOWMANAGER_CS_HLSL
#define HDSHADOWMANAGER_CS_HLSL

#if defined(STAND_IN_HDRP_SIX_CASCADES)
#define MAX_SHADOW_CASCADES 6
#define STAND_IN_HDRP_17
#define STAND_IN_HDRP_CASCADES MAX_SHADOW_CASCADES
#else
#define STAND_IN_HDRP_CASCADES 4
#endif

struct HDDirectionalShadowData
{
    float4 sphereCascades[STAND_IN_HDRP_CASCADES]; // w: squared radius
    real4 cascadeDirection;                        // w: count of cascades
    real cascadeBorders[STAND_IN_HDRP_CASCADES];
    float fadeScale;
    float fadeBias;
};

struct HDShadowData
{
    float3 rot0;
    float3 rot1;
    float3 rot2;
    float3 pos;
    float4 proj; // m00, m11, m22, m23
    float2 atlasOffset;
    float worldTexelSize;
    float normalBias;
    real4 zBufferParam;
    float4 shadowMapSize;
    float4 shadowFilterParams0;
#if defined(STAND_IN_HDRP_17)
    float4 dirLightPCSSParams0;
    float4 dirLightPCSSParams1;
#endif
    float3 cacheTranslationDelta;
    float isInCachedAtlas;
    float4x4 shadowToWorld;
};

#endif
