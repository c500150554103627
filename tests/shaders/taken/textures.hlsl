// compile: --stage compute
Texture2D Plain, Second; Texture2DArray Layers; TextureCube Cube; TextureCubeArray Cubes; Texture3D Volume; Texture1D Line;
Texture2DMS<float4> Samples; Buffer<float4> Texels; RWTexture2D<float4> Image; RWTexture2DArray<float4> Images;
SamplerState S; SamplerComparisonState C; RWStructuredBuffer<float> _Out;
float Loaded(Texture2DArray t) { return t.Load(int4(1, 2, 1, 0)).x; }
float Sampled(Texture2DArray t) { return t.SampleLevel(S, float3(0.5, 0.5, 1), 0).x; }
float Gathered(Texture2DArray t) { return t.GatherRed(S, float3(0.5, 0.5, 1)).x; }
float OfCube(TextureCube t) { return t.SampleLevel(S, float3(0, 0, 1), 0).x; }
float One(Texture2D t) { return t.SampleLevel(S, 0.5, 0).x; }
float Other(Texture2D t) { return t.SampleCmpLevelZero(C, 0.5, 0.5); }
struct Pair { Texture2D t; SamplerState s; float n; };
float OfPair(Pair p) { return p.t.SampleLevel(p.s, 0.5, 0).x; }
float OfPairInParts() { Pair p; p.t = Plain; p.s = S; return OfPair(p); }
[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    _Out[0] = Loaded(Layers) + Sampled(Layers) + Gathered(Layers);
    _Out[1] = OfCube(Cube);
    _Out[2] = Plain.Load(int3(1, 2, 0)).x;
    _Out[3] = Plain[id.xy].x;
    _Out[4] = Plain.SampleLevel(S, float2(0.5, 0.5), 0).x;
    _Out[5] = Plain.GatherRed(S, float2(0.5, 0.5)).x;
    _Out[6] = Plain.SampleCmpLevelZero(C, float2(0.5, 0.5), 0.5);
    _Out[7] = Layers.SampleCmpLevelZero(C, float3(0.5, 0.5, 1), 0.5);
    _Out[8] = Cubes.SampleLevel(S, float4(0, 0, 1, 1), 0).x;
    _Out[9] = Volume.Load(int4(1, 1, 1, 0)).x;
    _Out[10] = Volume.SampleLevel(S, float3(0, 0, 0), 0).x;
    _Out[11] = Line.SampleLevel(S, 0.5, 0).x;
    _Out[12] = Samples.Load(int2(1, 1), 0).x;
    _Out[13] = Texels[id.x].x;
    _Out[14] = Image[id.xy].x;
    _Out[15] = Images[uint3(id.xy, 1)].x;
    _Out[16] = Plain.SampleLevel(S, float3(0.5, 0.5, 1), 0).x;  // a vector too long is shortened
    _Out[17] = One(Plain) + One(Second) + Other(Plain) + OfPairInParts();
}
