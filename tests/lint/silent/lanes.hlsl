// compile: --stage compute --entry Apart
// compile: --stage compute --entry OneRow
RWStructuredBuffer<uint> W; uint _Lanes;
[numthreads(8, 8, 1)] void Apart(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    uint sum = WaveActiveSum(t) + WavePrefixSum(t);
    if (WaveGetLaneIndex() == WaveGetLaneCount() - 1) W[t] = sum;
    if (WaveIsFirstLane() && t > 3) W[id.x] = WaveReadLaneAt(sum, WaveGetLaneIndex() ^ 1) + t / _Lanes;
}
[numthreads(64, 1, 1)] void OneRow(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    W[id.x] = t / WaveGetLaneCount();  // a note
}
