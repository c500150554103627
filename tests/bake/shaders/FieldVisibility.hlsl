// Test: the visibility of a light from receivers, through a distance field.
#include "Platform/Platform.hlsl"
#include "Fields/DistanceFieldMarch.hlsl"

StructuredBuffer<float4> _Receivers; // positions in the field's space
RWStructuredBuffer<float> _Visibility;
TEXTURE3D(_Field);
SAMPLER(sampler_Linear);

CBUFFER_START(Parameters)
    float4 _Corner; // xyz: corner, w: largest distance
    float4 _Size;   // xyz: size, w: edge of a voxel
    float4 _Light;  // direction towards it, tan of half its diameter
    float4 _March;  // length, steps
CBUFFER_END

[numthreads(64, 1, 1)] void Hard(uint3 id : SV_DispatchThreadID)
{
    _Visibility[id.x] = FieldHardVisibility(TEXTURE3D_ARGS(_Field, sampler_Linear), _Receivers[id.x].xyz, _Light.xyz,
                                            _March.x, int(_March.y), BoundedFieldBox(_Corner, _Size));
}

[numthreads(64, 1, 1)] void Soft(uint3 id : SV_DispatchThreadID)
{
    _Visibility[id.x] = FieldSoftVisibility(TEXTURE3D_ARGS(_Field, sampler_Linear), _Receivers[id.x].xyz, _Light.xyz,
                                            _March.x, _Light.w, int(_March.y), BoundedFieldBox(_Corner, _Size));
}
