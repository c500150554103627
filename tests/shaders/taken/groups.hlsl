// compile: --stage compute --entry AsManyAsDirect3DTakes
// compile: --stage compute --entry AsManyAlongZ
// compile: --stage compute --entry SharedMemory
RWBuffer<float> _Out; groupshared struct { float3 v; uint k; } s[2048]; groupshared float4 unused[4096];
[numthreads(1024, 1, 1)] void AsManyAsDirect3DTakes(uint3 id : SV_GroupThreadID) { _Out[id.x] = 1; }
[numthreads(4, 4, 64)] void AsManyAlongZ(uint3 id : SV_GroupThreadID) { _Out[id.x] = 1; }
[numthreads(64, 1, 1)] void SharedMemory(uint3 id : SV_GroupThreadID)
{
    s[id.x].v = id.x; GroupMemoryBarrierWithGroupSync(); _Out[id.x] = s[id.y].v.x;
}
