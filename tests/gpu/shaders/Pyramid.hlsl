// Test: one level of a pyramid of maxima from the one below it; and a count of the texels above a limit, as
// the groups of the dispatch that follows.
Texture2D<float> _Below;
RWTexture2D<float> _Above;
RWStructuredBuffer<uint> _Groups;

[numthreads(1, 1, 1)] void Reduce(uint3 id : SV_DispatchThreadID)
{
    const int3 at = int3(2 * id.xy, 0);
    _Above[id.xy] = max(max(_Below.Load(at), _Below.Load(at + int3(1, 0, 0))),
                        max(_Below.Load(at + int3(0, 1, 0)), _Below.Load(at + int3(1, 1, 0))));
}

[numthreads(1, 1, 1)] void CountGroups(uint3 id : SV_DispatchThreadID)
{
    uint ignored;
    if (_Below.Load(int3(id.xy, 0)) > 0.5)
        InterlockedAdd(_Groups[0], 1u, ignored);
    if (all(id.xy == 0))
    {
        _Groups[1] = 1;
        _Groups[2] = 1;
    }
}

RWStructuredBuffer<uint> _Ran;

[numthreads(1, 1, 1)] void Run(uint3 id : SV_DispatchThreadID)
{
    _Ran[id.x] = 7;
}
