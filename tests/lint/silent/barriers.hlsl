// compile: --stage compute --entry Own
// compile: --stage compute --entry Reduction
// compile: --stage compute --entry Border
// compile: --stage compute --entry Segments
// compile: --stage compute --entry Loops
// compile: --stage compute --entry FirstIteration
// compile: --stage compute --entry OneThread
// compile: --stage compute --entry Members
// compile: --stage compute --entry Unknown
// compile: --stage compute --entry Alone
struct Item { float a; float b; };
groupshared float S[256]; groupshared Item I[64]; groupshared uint N;
RWStructuredBuffer<float> W; StructuredBuffer<float> R; uint _At;
[numthreads(8, 8, 1)] void Own(uint3 id : SV_DispatchThreadID, uint3 g : SV_GroupThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    N = 3;
    W[id.x] = S[g.y * 8 + g.x] + N;
    GroupMemoryBarrierWithGroupSync();
    W[id.x] += S[t ^ 1];
}
[numthreads(64, 1, 1)] void Reduction(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    for (uint step = 32; step > 0; step >>= 1)
    {
        GroupMemoryBarrierWithGroupSync();
        if (t < step) S[t] += S[t + step];
    }
    if (t == 0) W[id.x] = S[0];
}
[numthreads(64, 1, 1)] void Border(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    if (t < 16) S[t + 64] = R[id.x + 64];
    W[id.x] = S[t + 64];
}
[numthreads(64, 1, 1)] void Segments(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t * 4] = R[id.x]; S[t * 4 + 1] = 1; S[t * 4 + 2] = 2; S[t * 4 + 3] = 3;
    W[id.x] = S[t * 4 + 3] + S[t * 4 + 1];
}
[numthreads(64, 1, 1)] void Loops(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    float sum = 0;
    for (uint i = 0; i < _At; ++i)
    {
        GroupMemoryBarrierWithGroupSync();
        sum += S[63 - t];
        GroupMemoryBarrierWithGroupSync();
        S[t] = sum;
    }
    GroupMemoryBarrierWithGroupSync();
    W[id.x] = S[63 - t];
}
[numthreads(64, 1, 1)] void FirstIteration(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[t] = R[id.x];
    for (uint i = 0; i < 4; ++i) GroupMemoryBarrierWithGroupSync();
    W[id.x] = S[63 - t];
}
[numthreads(64, 1, 1)] void OneThread(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    if (t == 5)
    {
        for (uint i = 0; i < 64; ++i) S[i] = R[i];
        for (uint j = 0; j < 64; ++j) W[j] = S[63 - j];
    }
}
[numthreads(64, 1, 1)] void Members(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    I[t].a = R[id.x];
    W[id.x] = I[t].a + I[63 - t].b;
}
[numthreads(64, 1, 1)] void Unknown(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    S[_At] = 1;
    S[R[id.x]] = 2;
    W[id.x] = S[R[id.x + 1]] + S[_At];
}
[numthreads(1, 1, 1)] void Alone(uint3 id : SV_DispatchThreadID, uint t : SV_GroupIndex)
{
    for (uint i = 0; i < 64; ++i) S[i] = R[i];
    W[id.x] = S[3];
}
