// compile: --stage compute --entry Reads
RWTexture2D<float4> _Colour; RWTexture2D<float> _One; RWTexture2D<uint> _Number; RWBuffer<int> _Buffer;
Texture2D<float4> _Read; RWStructuredBuffer<float4> _Struct;
[numthreads(8, 8, 1)] void Reads(uint3 id : SV_DispatchThreadID)
{
    _Colour[id.xy] = _Read[id.xy] + _Struct[id.x];
    _One[id.xy] += _Number[id.xy] + _Buffer[id.x];
    InterlockedAdd(_Number[id.xy], 1);
}
