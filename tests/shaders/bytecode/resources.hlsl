// All kinds of resources and of uniforms. resources.dxbc is what FXC 10.0.26100 makes of it: Main, cs_5_0.
Texture2D<float> _Map;
Texture2D<float> _Compared;
Texture2DArray<uint2> _Layers;
SamplerState sampler_Map;
SamplerComparisonState sampler_Compare;
float4x4 _Matrices[3];
float _One;
float2 _Two;  // shares a register with _One
float _Array[3];
int4 _Integers;
uint _Unsigned;
struct Disc
{
    float3 centre;
    float radii[2];
};
cbuffer Named
{
    float4 _First;
    row_major float3x4 _Rows;
    float3x4 _Columns;
    float _Unread;
    Disc _Discs[2];
}
struct Particle
{
    float3 position;
    uint kind;
};
StructuredBuffer<Particle> _Particles;
ByteAddressBuffer _Bytes;
RWStructuredBuffer<float> _Out;
RWTexture2D<float> _Image;
RWTexture2DArray<float4> _Images;

[numthreads(8, 4, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    float4 v = mul(_Matrices[id.x % 3], float4(id, 1.0)) + _First;
    float sum = _Map.SampleLevel(sampler_Map, v.xy, 0) + _Compared.SampleCmpLevelZero(sampler_Compare, v.xy, v.z);
    sum += _One + _Two.y + _Array[id.y % 3] + _Integers.w + _Unsigned + mul(_Rows, v).y + mul(_Columns, v).z;
    sum += _Discs[id.y % 2].centre.z + _Discs[id.y % 2].radii[1];
    [loop]
    for (uint i = 0; i < id.x; ++i)
    {
        if (_Particles[i].kind > 3) sum += _Particles[i].position.y;
        sum += _Layers[uint3(i, 0, 1)].y;
    }
    sum += asfloat(_Bytes.Load(4 * id.x));
    _Out[id.x] = sum;
    _Image[id.xy] = sum;
    _Images[id] = v;
}
