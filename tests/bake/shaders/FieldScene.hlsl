// Test: the visibility of a light from receivers, through the distance fields of several objects.
#include "Platform/Platform.hlsl"
#include "Fields/DistanceFieldScene.hlsl"

StructuredBuffer<float4> _Receivers; // positions in the world
RWStructuredBuffer<float> _Visibility;
TEXTURE3D(_Field);
SAMPLER(sampler_Linear);

CBUFFER_START(Parameters)
    float4 _Light;  // direction towards it, tan of half its diameter
    float4 _March;  // length, steps
    float4 _Normal; // normal of the receivers' surface
CBUFFER_END

#define FIELD TEXTURE3D_ARGS(_Field, sampler_Linear)

[numthreads(64, 1, 1)] void Hard(uint3 id : SV_DispatchThreadID)
{
    _Visibility[id.x] = FieldSceneHardVisibility(FIELD, _Receivers[id.x].xyz, _Normal.xyz, _Light.xyz, _March.x,
                                                 int(_March.y));
}

[numthreads(64, 1, 1)] void Cone(uint3 id : SV_DispatchThreadID)
{
    _Visibility[id.x] = FieldSceneConeVisibility(FIELD, _Receivers[id.x].xyz, _Normal.xyz, _Light.xyz, _March.x,
                                                 _Light.w, int(_March.y));
}

[numthreads(64, 1, 1)] void Soft(uint3 id : SV_DispatchThreadID)
{
    _Visibility[id.x] = FieldSceneSoftVisibility(FIELD, _Receivers[id.x].xyz, _Normal.xyz, _Light.xyz, _March.x,
                                                 _Light.w, int(_March.y));
}

// Six numbers of the first object alone.
[numthreads(64, 1, 1)] void Parts(uint3 id : SV_DispatchThreadID)
{
    const FieldRay ray = RayOfFieldObject(0, _Receivers[id.x].xyz, _Normal.xyz, _Light.xyz, _March.x);
    const FieldParts parts = FieldPartsVisibility(FIELD, ray.origin, ray.direction, ray.farthest, _Light.w,
                                                  int(_March.y), ray.box);
    for (int i = 0; i < 3; ++i)
    {
        _Visibility[6 * id.x + i] = parts.first[i];
        _Visibility[6 * id.x + 3 + i] = parts.second[i];
    }
}

// The distance to the first object, as the march knows it.
[numthreads(64, 1, 1)] void Distance(uint3 id : SV_DispatchThreadID)
{
    const FieldRay ray = RayOfFieldObject(0, _Receivers[id.x].xyz, float3(0.0, 0.0, 0.0), _Light.xyz, _March.x);
    _Visibility[id.x] = FieldDistance(FIELD, ray.origin, ray.box);
}
