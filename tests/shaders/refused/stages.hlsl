// stages.hlsl:11: error: a groupshared variable is used in a fragment program: only compute programs have them
// stages.hlsl:12: error: a groupshared variable is used in a fragment program: only compute programs have them
// stages.hlsl:14: error: a barrier waits for the threads of a group, and a fragment program has none: only compute programs have barriers with sync
// stages.hlsl:15: error: clip() and discard end a pixel, and a vertex program has none: only fragment programs have them
// compile: --entry Groupshared
// compile: --entry Barrier
// compile: --stage vertex --entry Clip
groupshared float Shared[4];
float4 Groupshared(float4 p : SV_Position) : SV_Target
{
    Shared[0] = p.x;
    return Shared[int(p.y)];
}
float4 Barrier(float4 p : SV_Position) : SV_Target { GroupMemoryBarrierWithGroupSync(); return p; }
float4 Clip(float4 p : POSITION) : SV_Position { clip(p.x); return p; }
