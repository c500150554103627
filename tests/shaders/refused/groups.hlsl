// groups.hlsl:11: error: the groupshared variables take 32784 bytes, and Direct3D has 32768 for a group
// groups.hlsl:12: error: [numthreads] makes groups of 2048 threads, and Direct3D takes 1024 at most
// groups.hlsl:13: error: [numthreads] has 65 threads along z, and Direct3D takes 1 to 64
// groups.hlsl:14: error: [numthreads] has 0 threads along y, and Direct3D takes 1 to 1024
// groups.hlsl:15: error: [numthreads] has 1025 threads along x, and Direct3D takes 1 to 1024
// compile: --stage compute --entry TooMany
// compile: --stage compute --entry AlongZ
// compile: --stage compute --entry NoneAlongY
// compile: --stage compute --entry AlongX
// compile: --stage compute --entry Shared
RWBuffer<float> _Out; groupshared struct { float3 v; uint k; } s[2049];
[numthreads(32, 32, 2)] void TooMany(uint3 id : SV_GroupThreadID) { _Out[id.x] = 1; }
[numthreads(1, 1, 65)] void AlongZ(uint3 id : SV_GroupThreadID) { _Out[id.x] = 1; }
[numthreads(1, 0, 1)] void NoneAlongY(uint3 id : SV_GroupThreadID) { _Out[id.x] = 1; }
[numthreads(1025, 1, 1)] void AlongX(uint3 id : SV_GroupThreadID) { _Out[id.x] = 1; }
[numthreads(64, 1, 1)] void Shared(uint3 id : SV_GroupThreadID)
{
    s[id.x].v = id.x; GroupMemoryBarrierWithGroupSync(); _Out[id.x] = s[id.y].v.x;
}
