// operations.dxbc is what FXC 10.0.26100 makes of it: Main, cs_5_0. Its operations for each thread are listed below.
struct Pair
{
    uint kind;
    float value;
};
StructuredBuffer<Pair> _In;
RWStructuredBuffer<float> _Out;
groupshared float shared_[64];
[numthreads(8, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    const Pair pair = _In[id.x];
    shared_[id.x] = pair.value;
    GroupMemoryBarrierWithGroupSync();
    float value = sqrt(shared_[id.x ^ 1]) * 3.0 + 1.0;
    if (pair.kind != 0) value = value < 2.0 ? value : pair.value;
    [branch]
    if (value > 5.0) value = 1.0 / value;
    _Out[id.x] = value;
}
