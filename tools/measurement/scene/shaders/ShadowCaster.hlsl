// Penumbra tools: a cascade tile's shadow casters, as URP's shadow caster pass draws them.
//
// Computes:   clip-space position of a biased caster vertex; the map keeps its depth.
// Source:     URP's ShadowCasterPass: bias along light and normal, then the clamp to the near plane ("pancaking").
// Inputs:     _ShadowRow0..2: rows of the matrix from the mesh's space to (clip x, clip y, stored depth), clip y = -1
//             at the tile's first row; _TowardLight: unit, xyz; _Bias: URP's depth and normal bias, metres, <= 0.
// Cost:       no texture fetches; with PENUMBRA_CUT_OUTS, which needs the fragment shader, CutOut.hlsl's.
// Guarantees: no caster between the sun and the near plane is lost.
// Use it:     by the rasteriser (tools/measurement/scene).
#include "SceneMesh.hlsl"
#if PENUMBRA_CUT_OUTS
#include "CutOut.hlsl"
#endif
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

struct Caster
{
    float4 positionCS : SV_Position;
#if PENUMBRA_CUT_OUTS
    float2 uv : TEXCOORD0;
    nointerpolation uint triangleNumber : TEXCOORD1;
#endif
};

float4 ShadowPosition(float4 homogeneous)
{
    const float depth = dot(_Tile.shadowRow2, homogeneous);
    return float4(dot(_Tile.shadowRow0, homogeneous), dot(_Tile.shadowRow1, homogeneous),
                  DepthGap(depth, kNearestDepth) > 0.0 ? kNearestDepth : depth, 1.0);
}

Caster Main(uint corner : SV_VertexID)
{
    const float3 position =
        BiasCaster(CornerPosition(corner), CornerNormal(corner), _Tile.towardLight.xyz, _Tile.bias.xy);
    Caster caster;
    caster.positionCS = ShadowPosition(float4(position, 1.0));
#if PENUMBRA_CUT_OUTS
    caster.uv = CornerTexCoord(corner);
    caster.triangleNumber = corner / 3;
#endif
    return caster;
}

#if PENUMBRA_CUT_OUTS
void Fragment(Caster caster)
{
    if (IsOpen(caster.triangleNumber, caster.uv))
        discard;
}
#endif
