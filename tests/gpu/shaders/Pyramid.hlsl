// Test: one level of a pyramid of maxima from the one below it; a count of the texels above a limit; and zeros.
Texture2D<float> _Below;
RWTexture2D<float> _Above;
RWStructuredBuffer<uint> _Count;

[numthreads(1, 1, 1)] void Reduce(uint3 id : SV_DispatchThreadID)
{
    const int3 at = int3(2 * id.xy, 0);
    _Above[id.xy] = max(max(_Below.Load(at), _Below.Load(at + int3(1, 0, 0))),
                        max(_Below.Load(at + int3(0, 1, 0)), _Below.Load(at + int3(1, 1, 0))));
}

[numthreads(1, 1, 1)] void Count(uint3 id : SV_DispatchThreadID)
{
    uint ignored;
    if (_Below.Load(int3(id.xy, 0)) > 0.5)
        InterlockedAdd(_Count[0], 1u, ignored);
}

RWStructuredBuffer<uint> _Zeroed;

[numthreads(1, 1, 1)] void Zeros(uint3 id : SV_DispatchThreadID)
{
    _Zeroed[id.x] = 0;
}
