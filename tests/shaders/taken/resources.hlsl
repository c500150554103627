// compile: --entry Loads
// compile: --entry RegistersOfTwo
Texture2D<float4> _Map; Texture2DMS<float4> _Samples; Buffer<float4> _Words; RWTexture2D<float4> _Image;
Texture3D _Volume; Texture1D _Line;
float4 Loads(float4 p : SV_Position) : SV_Target
{
    return _Samples.Load(int2(p.xy), 1) + _Words.Load(1) + _Image.Load(int2(p.xy)) + _Volume.Load(int4(p)) +
           _Line.Load(int2(p.xy)) + _Map.Load(int3(p.xy, 0)) + _Map[p.xy];
}

// _B is not used.
Texture2D _A : register(t3), _B : register(t3);
Texture2D _C : register(t3, space1);
cbuffer C : register(b3) { float c; }
SamplerState _S : register(s3);
float4 RegistersOfTwo(float4 p : SV_Position) : SV_Target { return _A.Sample(_S, p.xy) + _C.Load(0) + c; }
