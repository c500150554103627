// Penumbra tools: a cascade tile's shadow casters, as URP's shadow caster pass draws them.
//
// Computes:   clip-space position of a biased caster vertex; the map keeps its depth.
// Source:     URP's ShadowCasterPass: bias along light and normal, then the clamp to the near plane ("pancaking").
// Inputs:     _ShadowRow0..2: rows of the matrix from the mesh's space to (clip x, clip y, stored depth), clip y = -1
//             at the tile's first row; _TowardLight: unit, xyz; _Bias: URP's depth and normal bias, metres, <= 0.
// Cost:       no texture fetches.
// Guarantees: no caster between the light and the near plane is lost.
// Use it:     by the rasteriser (tools/scene).
#include "SceneMesh.hlsl"
#include "Core/DepthConvention.hlsl"
#include "Core/ShadowBias.hlsl"

struct CasterTile
{
    float4 shadowRow0;
    float4 shadowRow1;
    float4 shadowRow2;
    float4 towardLight;
    float4 bias;
};
[[vk::push_constant]] ConstantBuffer<CasterTile> _Tile;

float4 Main(uint corner : SV_VertexID) : SV_Position
{
    const float3 position =
        BiasCaster(CornerPosition(corner), CornerNormal(corner), _Tile.towardLight.xyz, _Tile.bias.xy);
    const float4 homogeneous = float4(position, 1.0);
    const float depth = dot(_Tile.shadowRow2, homogeneous);
    return float4(dot(_Tile.shadowRow0, homogeneous), dot(_Tile.shadowRow1, homogeneous),
                  DepthGap(depth, kNearestDepth) > 0.0 ? kNearestDepth : depth, 1.0);
}
