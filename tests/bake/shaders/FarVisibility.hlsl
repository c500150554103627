// Test: the visibility of receivers by horizon angles and by a trace over heights.
#include "Platform/Platform.hlsl"
#include "Far/CloudShadow.hlsl"
#include "Far/HeightFieldTrace.hlsl"

StructuredBuffer<float4> _Receivers; // world position
RWStructuredBuffer<float> _Visibility;
TEXTURE2D(_First);
TEXTURE2D(_Second);
TEXTURE2D(_Heights);
TEXTURE2D(_Clouds);
SAMPLER(sampler_Linear);

CBUFFER_START(Parameters)
    float4 _Area;
    float4 _SunAndHalfDiameter;
    float4 _HeightsAndTexels;
    float4 _Ray; // nearest, steps, jitter
    float4 _Channels;
CBUFFER_END

[numthreads(64, 1, 1)] void Angles(uint3 id : SV_DispatchThreadID)
{
    const GroundMap ground = BoundedGroundMap(_Area, _HeightsAndTexels.xy);
    _Visibility[id.x] = HorizonAnglesVisibility(TEXTURE2D_ARGS(_First, _Second), sampler_Linear, _Receivers[id.x].xyz,
                                                _SunAndHalfDiameter.xyz, _SunAndHalfDiameter.w, ground);
}

[numthreads(64, 1, 1)] void Trace(uint3 id : SV_DispatchThreadID)
{
    const GroundMap ground = BoundedGroundMap(_Area, _HeightsAndTexels.xy);
    HeightFieldRay ray;
    ray.nearestMetres = _Ray.x;
    ray.steps = int(_Ray.y);
    ray.jitter = _Ray.z;
    ray.channels = _Channels.xy;
    _Visibility[id.x] = HeightFieldVisibility(TEXTURE2D_ARGS(_Heights, sampler_Linear), _HeightsAndTexels.zw,
                                              _Receivers[id.x].xyz, _SunAndHalfDiameter.xyz, _SunAndHalfDiameter.w, ray,
                                              ground);
}

[numthreads(64, 1, 1)] void Clouds(uint3 id : SV_DispatchThreadID)
{
    // x and y hold the layer's height and border here.
    const CloudLayer layer = BoundedCloudLayer(_Area, _HeightsAndTexels.x, _HeightsAndTexels.y);
    _Visibility[id.x] = CloudVisibility(TEXTURE2D_ARGS(_Clouds, sampler_Linear), _Receivers[id.x].xyz,
                                        _SunAndHalfDiameter.xyz, layer);
}
