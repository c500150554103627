// barriers.hlsl:20:15: warning: thread 0 of a group reads from 'S' what thread 1 writes at line 19, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// barriers.hlsl:26:42: warning: thread 0 of a group reads from 'S' what thread 1 writes at line 24, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// barriers.hlsl:32:9: warning: thread 1 of a group reads from 'N' what thread 0 writes at line 31, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// barriers.hlsl:37:15: warning: thread 0 of a group reads from 'P' what thread 1 writes at line 36, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// barriers.hlsl:46: warning: thread 0 of a group reads from 'S' what thread 16 writes at line 45, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// barriers.hlsl:59:13: warning: thread 0 of a group reads from 'S' what thread 63 writes at line 60, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// barriers.hlsl:68:15: warning: thread 0 of a group reads from 'S' what thread 2 writes at line 66, and may read before it is written: put GroupMemoryBarrierWithGroupSync() between them [missing-barrier]
// compile: --stage compute --entry Neighbour
// compile: --stage compute --entry Sum
// compile: --stage compute --entry Flag
// compile: --stage compute --entry TwoDimensions
// compile: --stage compute --entry LastSteps
// compile: --stage compute --entry NextIteration
// compile: --stage compute --entry MemoryAlone
groupshared float S[80]; groupshared float2 P[8][8]; groupshared uint N;
RWStructuredBuffer<float> W; StructuredBuffer<float> R;
[numthreads(64, 1, 1)] void Neighbour(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    W[id.x] = S[t ^ 1];
}
[numthreads(64, 1, 1)] void Sum(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    float sum = 0;
    for (uint i = 0; i < 64; ++i) sum += S[i];
    W[id.x] = sum;
}
[numthreads(64, 1, 1)] void Flag(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    if (t == 0) N = R[0];
    if (N > 3) W[id.x] = 1;
}
[numthreads(8, 8, 1)] void TwoDimensions(uint3 id : SV_DispatchThreadID, uint3 t : SV_GroupThreadID)
{
    P[t.y][t.x] = R[id.x];
    W[id.x] = P[t.y][t.x == 7 ? 0 : t.x + 1].y;
}
[numthreads(64, 1, 1)] void LastSteps(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    GroupMemoryBarrierWithGroupSync();
    if (t < 32)
    {
        S[t] += S[t + 32];
        S[t] += S[t +
                  16];
    }
    GroupMemoryBarrierWithGroupSync();
    W[id.x] = S[0];
}
[numthreads(64, 1, 1)] void NextIteration(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = 0;
    GroupMemoryBarrierWithGroupSync();
    for (uint i = 0; i < 4; ++i)
    {
        float mine =
            S[63 - t];
        S[t] = mine + i;
    }
    W[id.x] = S[t];
}
[numthreads(64, 1, 1)] void MemoryAlone(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    GroupMemoryBarrier();
    W[id.x] = S[t ^ 2];
}
