// Comparison: the soft shadow of a distance field by this library and by three published marches, and the fetches of
// each.
#include "Platform/Platform.hlsl"

static float s_fetches = 0.0;
#undef SAMPLE_TEXTURE3D_LOD
#define SAMPLE_TEXTURE3D_LOD(textureName, samplerName, uvw, lod) \
    (s_fetches += 1.0, textureName.SampleLevel(samplerName, uvw, lod))

#include "Fields/DistanceFieldMarch.hlsl"

StructuredBuffer<float4> _Receivers; // positions in the field's space
RWStructuredBuffer<float2> _Visibility; // x: visibility, y: fetches
TEXTURE3D(_Field);
SAMPLER(sampler_Linear);

CBUFFER_START(Parameters)
    float4 _Corner; // xyz: corner, w: largest distance
    float4 _Size;   // xyz: size, w: edge of a voxel
    float4 _Light;  // direction towards it, tan of half its diameter
    float4 _March;  // length, steps
CBUFFER_END

// Two published marches, in the same box: Quilez, "Free penumbra shadows for raymarching distance fields" (2010), and
// with `between`, Aaltonen, "GPU-based clay simulation and ray-tracing tech in Claybook" (GDC 2018), who estimates the
// nearest place between two steps.
float Published(float3 origin, float3 direction, float farthest, float spread, int steps, DistanceFieldBox box,
                bool between)
{
    const float2 range = ConeThroughBox(origin, direction, farthest, spread, box);
    float t = max(range.x, 1e-4 * box.voxelMetres);
    float visibility = 1.0;
    float before = 1e20;
    for (int i = 0; i < steps && t < range.y; ++i)
    {
        const float distance = FieldDistance(TEXTURE3D_ARGS(_Field, sampler_Linear), origin + t * direction, box);
        if (distance < 0.01 * box.voxelMetres) return 0.0;
        const float back = between ? distance * distance / (2.0 * before) : 0.0;
        const float beside = sqrt(max(distance * distance - back * back, 0.0));
        visibility = min(visibility, beside / (spread * max(t - back, 1e-4 * box.voxelMetres)));
        before = distance;
        t += max(distance, 0.25 * box.voxelMetres);
    }
    return visibility;
}

// The later march of Quilez's article, https://iquilezles.org/articles/rmshadows: it goes on within the object, so
// that distance / t falls below 0 and the penumbra has an inner half; smoothstep over [-1, 1] gives the visibility. His
// steps within the object are as short as his shortest; here they are those of the other marches.
float PublishedInner(float3 origin, float3 direction, float farthest, float spread, int steps, DistanceFieldBox box)
{
    const float2 range = ConeThroughBox(origin, direction, farthest, spread, box);
    float t = max(range.x, 1e-4 * box.voxelMetres);
    float free = 1.0;
    for (int i = 0; i < steps && t < range.y && free > -1.0; ++i)
    {
        const float distance = FieldDistance(TEXTURE3D_ARGS(_Field, sampler_Linear), origin + t * direction, box);
        free = min(free, distance / (spread * t));
        t += max(distance, 0.25 * box.voxelMetres);
    }
    free = max(free, -1.0);
    return 0.25 * (1.0 + free) * (1.0 + free) * (2.0 - free);
}

[numthreads(64, 1, 1)] void QuilezInner(uint3 id : SV_DispatchThreadID)
{
    const float visibility = PublishedInner(_Receivers[id.x].xyz, _Light.xyz, _March.x, _Light.w, int(_March.y),
                                            BoundedFieldBox(_Corner, _Size));
    _Visibility[id.x] = float2(visibility, s_fetches);
}

[numthreads(64, 1, 1)] void Quilez(uint3 id : SV_DispatchThreadID)
{
    const float visibility = Published(_Receivers[id.x].xyz, _Light.xyz, _March.x, _Light.w, int(_March.y),
                                       BoundedFieldBox(_Corner, _Size), false);
    _Visibility[id.x] = float2(visibility, s_fetches);
}

[numthreads(64, 1, 1)] void Aaltonen(uint3 id : SV_DispatchThreadID)
{
    const float visibility = Published(_Receivers[id.x].xyz, _Light.xyz, _March.x, _Light.w, int(_March.y),
                                       BoundedFieldBox(_Corner, _Size), true);
    _Visibility[id.x] = float2(visibility, s_fetches);
}

[numthreads(64, 1, 1)] void Cone(uint3 id : SV_DispatchThreadID)
{
    const float visibility = FieldConeVisibility(TEXTURE3D_ARGS(_Field, sampler_Linear), _Receivers[id.x].xyz,
                                                 _Light.xyz, _March.x, _Light.w, int(_March.y),
                                                 BoundedFieldBox(_Corner, _Size));
    _Visibility[id.x] = float2(visibility, s_fetches);
}

[numthreads(64, 1, 1)] void Soft(uint3 id : SV_DispatchThreadID)
{
    const float visibility = FieldSoftVisibility(TEXTURE3D_ARGS(_Field, sampler_Linear), _Receivers[id.x].xyz,
                                                 _Light.xyz, _March.x, _Light.w, int(_March.y),
                                                 BoundedFieldBox(_Corner, _Size));
    _Visibility[id.x] = float2(visibility, s_fetches);
}
