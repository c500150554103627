// Penumbra tools: a cascade tile's shadow casters, as URP's shadow caster pass draws them.
//
// Computes:   clip-space position of a biased caster vertex; the map keeps its depth.
// Source:     URP's ShadowCasterPass: bias along light and normal, then the clamp to the near plane ("pancaking").
// Inputs:     _ShadowRow0..2: rows of the matrix from the mesh's space to (clip x, clip y, stored depth), clip y = -1
//             at the tile's first row; _TowardLight: unit, xyz; _Bias: URP's depth and normal bias, metres, <= 0.
//             With PENUMBRA_SPOT_LIGHT the rows are those of clip x, clip y and stored depth times w, and a row of w
//             follows; in the place of _TowardLight is _LightPosition, in the mesh's space.
// Cost:       no texture fetches; with PENUMBRA_CUT_OUTS, which needs the fragment shader, CutOut.hlsl's.
// Guarantees: no caster between the sun and the near plane is lost. A spot light's are, as in URP.
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
#if PENUMBRA_SPOT_LIGHT
    float4 shadowRow3;
    float4 lightPosition;
#else
    float4 towardLight;
#endif
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

#if PENUMBRA_SPOT_LIGHT
float3 TowardLight(float3 position)
{
    return normalize(_Tile.lightPosition.xyz - position);
}

float4 ShadowPosition(float4 homogeneous)
{
    return float4(dot(_Tile.shadowRow0, homogeneous), dot(_Tile.shadowRow1, homogeneous),
                  dot(_Tile.shadowRow2, homogeneous), dot(_Tile.shadowRow3, homogeneous));
}
#else
float3 TowardLight(float3 position)
{
    return _Tile.towardLight.xyz;
}

float4 ShadowPosition(float4 homogeneous)
{
    const float depth = dot(_Tile.shadowRow2, homogeneous);
    return float4(dot(_Tile.shadowRow0, homogeneous), dot(_Tile.shadowRow1, homogeneous),
                  DepthGap(depth, kNearestDepth) > 0.0 ? kNearestDepth : depth, 1.0);
}
#endif

Caster Main(uint corner : SV_VertexID)
{
    const float3 unbiased = CornerPosition(corner);
    const float3 position = BiasCaster(unbiased, CornerNormal(corner), TowardLight(unbiased), _Tile.bias.xy);
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
