// interlocked.hlsl:9: error: an Interlocked function changes a buffer that can only be read: declare it as an RW buffer
// interlocked.hlsl:10: error: an Interlocked function changes a buffer that can only be read: declare it as an RW buffer
// interlocked.hlsl:11: error: an Interlocked function changes a local variable: it takes groupshared variables and elements of RW resources
// compile: --stage compute
StructuredBuffer<uint> B; ByteAddressBuffer Y; RWBuffer<uint> _Out;
[numthreads(1, 1, 1)] void Main()
{
    uint was, local = _Out[1];
    InterlockedAdd(B[1], 1u);
    Y.InterlockedAdd(4, 1u, was);
    InterlockedAdd(local, 2u);
    _Out[0] = B[1] + was + local;
}
