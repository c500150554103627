// lanes.hlsl:8:21: warning: a lane of the wave is taken for a thread of the group; HLSL does not say which thread is in which lane: count waves by an atomic in group shared memory, or exchange the values there [lane-order]
// lanes.hlsl:9:9: warning: a lane of the wave is taken for a thread of the group; HLSL does not say which thread is in which lane: count waves by an atomic in group shared memory, or exchange the values there [lane-order]
// lanes.hlsl:10:22: warning: a lane of the wave is taken for a thread of the group; HLSL does not say which thread is in which lane: count waves by an atomic in group shared memory, or exchange the values there [lane-order]
// compile: --stage compute --entry Lanes
RWStructuredBuffer<uint> W;
[numthreads(8, 8, 1)] void Lanes(uint3 id : SV_DispatchThreadID, uint3 g : SV_GroupThreadID, uint t : SV_GroupIndex)
{
    uint wave = t / WaveGetLaneCount();
    if (WaveGetLaneIndex() == t) ++wave;
    W[id.x] = wave + WaveReadLaneAt(wave, g.x & 3);
}
