// HDRP's own directional shadow at High quality, its PCSS by angular diameter, for comparison: penumbra measure
//   --package-root com.unity.render-pipelines.core=DIR --package-root com.unity.render-pipelines.high-definition=DIR
//   --adapter "hdrp-pcss=tools/measurement/resolve/adapters/HdrpPcss.hlsl;@depth-bias=0;@normal-bias=0;@light-scale=0.5"
// HDRP moves the receiver, not the casters: hence their biases of 0. Its penumbra is twice as wide as a disc of the
// diameter it is told makes it: a light scale of 0.5 gives it the light's own disc.
//
// Computes:   GetDirectionalShadowAttenuation of the HDRP whose package root is given: cascade selection, biases,
//             shadow coordinate, blocker search and filter, nothing of ours. HDRP's C# is not run: its shader data is
//             made here from the map's matrices and the light's diameter.
// Source:     the packing of HDRP 17 (HDShadowManager, HDShadowRequest), as Documentation~/pipelines.md lists it; the
//             light component's defaults.
// Inputs:     HDRP 17 (Unity 6). Version 14 is refused by the names of the fields it lacks: its softness comes from the
//             planes of the light's view, which the map's matrices do not tell.
//             The receiver moves along its normal by HDRP's default of 0.75 diagonals of a texel, and against the light
//             by HDRP's constant 1/65536; with HDRP_NO_NORMAL_BIAS by the latter alone.
// Cost:       HDRP's: up to 40 fetches. Its filter runs even where nothing blocks: HLSL evaluates both sides of ?:.
#define SHADER_API_D3D11 1

#if !UNITY_REVERSED_Z
#error HDRP draws its shadow maps with reversed depth: measure with --reversed-z true
#endif

// One name since the qualities of light types are apart, the other before.
#define SHADOW_HIGH
#define DIRECTIONAL_SHADOW_HIGH

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Random.hlsl"

// What the harness provides.
TEXTURE2D(_ShadowMap);
SAMPLER(sampler_PointClamp);
SAMPLER(sampler_LinearClamp);
SAMPLER_CMP(sampler_LinearClampCompare);
float4x4 _PenumbraWorldToShadow[5];
float4 _PenumbraTileOffsetScale[4];
float4 _PenumbraAtlasTexelSize;
float4 _PenumbraSplitSpheres[4];
float4 _PenumbraMainLightParams;
float4 _MainLightPosition;
float3 _WorldSpaceCameraPos;
int _PenumbraCascadeCount;
int _PenumbraNoiseFrame;

// What HDRP's ShaderVariables.hlsl declares and its shadow files read. Maps of other lights are declared only.
static float4 _TaaFrameInfo;
static float4 _CascadeShadowAtlasSize;
static uint _CascadeShadowCount;
static const float4 _ShadowAtlasSize = 0.0;
static const float4 _CachedShadowAtlasSize = 0.0;
static const float4 _AreaShadowAtlasSize = 0.0;
static const float4 _CachedAreaShadowAtlasSize = 0.0;
TEXTURE2D(_ShadowmapAtlas);
TEXTURE2D(_CachedShadowmapAtlas);
TEXTURE2D(_ShadowmapAreaAtlas);
TEXTURE2D(_CachedAreaLightShadowmapAtlas);
#define _ShadowmapCascadeAtlas _ShadowMap
#define s_point_clamp_sampler sampler_PointClamp
#define s_linear_clamp_sampler sampler_LinearClamp
#define s_linear_clamp_compare_sampler sampler_LinearClampCompare

float3 GetWorldSpaceViewDir(float3 positionWS) { return normalize(_WorldSpaceCameraPos - positionWS); }

// In place of HDRP's HDShadowContext.hlsl, by its guard: the same context with arrays for its buffers, which the
// harness does not have.
#define HD_SHADOW_CONTEXT_HLSL
#define HAVE_HD_SHADOW_CONTEXT
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/Lighting/Shadow/HDShadowManager.cs.hlsl"
struct HDShadowContext
{
    HDShadowData shadowDatas[4];
    HDDirectionalShadowData directionalShadowData;
};
#define SHADOW_USE_DEPTH_BIAS 1
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/Lighting/Shadow/HDShadowSampling.hlsl"
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/Lighting/Shadow/HDShadowAlgorithms.hlsl"
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/Lighting/LightLoop/HDShadow.hlsl"

// The light component's defaults.
static const int kBlockerSamples = 24;
static const int kFilterSamples = 16;
static const float kClump = 2.0;
static const float kMaxPenumbraMetres = 0.56;
static const float kMaxSamplingMetres = 0.5;
static const float kMinFilterTexels = 1.5;
static const float kMinFilterDegrees = 10.0;
static const float kSearchDegrees = 12.0;
#if defined(HDRP_NO_NORMAL_BIAS)
static const float kNormalBias = 0.0;
#else
static const float kNormalBias = 0.75;
#endif

float TanHalf(float degrees) { return tan(radians(0.5 * degrees)); }

// The rows of world to clip space: x, y in [-1, 1] over the tile, z the stored depth. HDRP keeps them as a unit row of
// the light's view, its offset, and the projection's scale. In depth the offset is the projection's: view and
// projection come as one matrix, and only their product is read.
void SetMatrix(inout HDShadowData data, float4x4 worldToShadow, float4 tile)
{
    const float4 x = (worldToShadow[0] - float4(0.0, 0.0, 0.0, tile.x)) * (2.0 / tile.z) - float4(0.0, 0.0, 0.0, 1.0);
    const float4 y = (worldToShadow[1] - float4(0.0, 0.0, 0.0, tile.y)) * (2.0 / tile.w) - float4(0.0, 0.0, 0.0, 1.0);
    const float4 z = worldToShadow[2];
    data.proj = float4(length(x.xyz), length(y.xyz), length(z.xyz), z.w);
    data.rot0 = x.xyz / data.proj.x;
    data.rot1 = y.xyz / data.proj.y;
    data.rot2 = z.xyz / data.proj.z;
    data.pos = float3(x.w / data.proj.x, y.w / data.proj.y, 0.0);
}

// With s = |m00 / m22|, which is HDRP's scale of depth to radius, and nested cones.
void SetPcss(inout HDShadowData data, float tanHalf)
{
    const float scale = data.proj.x / data.proj.z;
    const float searchTanHalf = max(tanHalf, TanHalf(kSearchDegrees));
    const float minFilterTanHalf = max(searchTanHalf, TanHalf(kMinFilterDegrees));
    data.shadowFilterParams0 = float4(0.0, asfloat(kBlockerSamples), asfloat(kFilterSamples), 0.0);
    data.dirLightPCSSParams0.x = tanHalf * scale; // HDRP has it since 17: give the root of no older one
    data.dirLightPCSSParams0.y = 1.0 / (tanHalf * scale);
    data.dirLightPCSSParams0.z = kMaxPenumbraMetres / (2.0 * tanHalf);
    data.dirLightPCSSParams0.w = kMaxSamplingMetres;
    data.dirLightPCSSParams1.x = kMinFilterTexels;
    data.dirLightPCSSParams1.y = 1.0 / (minFilterTanHalf * scale);
    data.dirLightPCSSParams1.z = 1.0 / (searchTanHalf * scale);
    data.dirLightPCSSParams1.w = 0.5 * kClump;
}

HDShadowData ShadowDataOf(int cascade)
{
    const float4 tile = _PenumbraTileOffsetScale[cascade];
    const float2 size = tile.zw * _PenumbraAtlasTexelSize.zw;
    HDShadowData data = (HDShadowData)0;
    SetMatrix(data, _PenumbraWorldToShadow[cascade], tile);
    SetPcss(data, _PenumbraMainLightParams.y);
    data.atlasOffset = tile.xy;
    data.shadowMapSize = float4(size, 1.0 / size);
    data.worldTexelSize = 2.0 / (data.proj.x * size.x) * sqrt(2.0);
    data.normalBias = kNormalBias;
    return data;
}

// No borders, HDRP's default: cascades do not blend.
HDDirectionalShadowData DirectionalDataOf(int count)
{
    HDDirectionalShadowData data = (HDDirectionalShadowData)0;
    for (int i = 0; i < count; ++i)
    {
        const float4 sphere = _PenumbraSplitSpheres[i];
        data.sphereCascades[i] = float4(sphere.xyz, sphere.w * sphere.w);
    }
    data.cascadeDirection.w = count;
    return data;
}

float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const int count = _PenumbraCascadeCount;
    HDShadowContext context;
    context.directionalShadowData = DirectionalDataOf(count);
    // HDRP's selection reads borders[-1] where no sphere holds the position, which is lit.
    bool covered = false;
    for (int i = 0; i < 4; ++i)
    {
        context.shadowDatas[i] = ShadowDataOf(min(i, count - 1));
        const float4 sphere = context.directionalShadowData.sphereCascades[i];
        const float3 fromCentre = positionWS - sphere.xyz;
        const float squaredDistance = dot(fromCentre, fromCentre);
        covered = covered || (squaredDistance > 0.0 && squaredDistance <= sphere.w);
    }
    if (!covered) return 1.0;

    _TaaFrameInfo = float4(0.0, 0.0, _PenumbraNoiseFrame, 0.0);
    _CascadeShadowAtlasSize = _PenumbraAtlasTexelSize.zwxy;
    _CascadeShadowCount = count;
    // HDRP counts pixels in integers.
    return GetDirectionalShadowAttenuation(context, floor(pixel), positionWS, normalWS, 0, _MainLightPosition.xyz);
}
