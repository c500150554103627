// compile: --stage compute
StructuredBuffer<uint> B; RWStructuredBuffer<uint> W; RWByteAddressBuffer Z; RWBuffer<uint> _Out;
groupshared uint Shared;
[numthreads(1, 1, 1)] void Main()
{
    uint was;
    Z.InterlockedAdd(4, B[0], was); InterlockedMax(W[B[1]], was);
    InterlockedAdd(Shared, 2u, was); InterlockedMax(_Out[0], was);
}
