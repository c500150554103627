// Test: takes time in proportion to the groups. It computes a chain of hashes that no compiler shortens, whose length
// stays below the 65535 rounds after which Mesa's software device leaves any loop.
RWStructuredBuffer<uint> _Result;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    uint value = id.x;
    for (uint round = 0; round < 50000; ++round)
        value = (value ^ (value >> 13)) * 1664525u + 1013904223u;
    _Result[0] = value;
}
