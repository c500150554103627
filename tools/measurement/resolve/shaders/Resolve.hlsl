// Evaluates one shadow function at every receiver of a frame.
//
// Stands after the platform macros and the technique (or the user's file), which define
//   float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade)     a technique
//   float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)    with PENUMBRA_ADAPTER
//
// PENUMBRA_SPOT_LIGHT: the map is a spot light's, one tile of which _PenumbraWorldToShadow[0] is the matrix, in
// perspective. Receivers that it does not cover are lit.
//
// Inputs: receivers in world space, metres; cascade constants as URP uploads them. Receivers with w = 0 saw no
// surface and get visibility 1. Receivers past every cascade are lit, as in URP.

#include "Core/ShadowStructs.hlsl"
#include "Core/CascadeSelection.hlsl"
#include "Core/Noise.hlsl"
#include "Core/ReceiverPlane.hlsl"
#include "Core/SpotLight.hlsl"

StructuredBuffer<float4> _PenumbraReceiverPositionWS;
StructuredBuffer<float4> _PenumbraReceiverNormalWS;
RWStructuredBuffer<float> _PenumbraVisibility;

int2 _PenumbraImageSize;

#if !defined(PENUMBRA_ADAPTER)  // an adapter declares those that it reads
int _PenumbraNoiseFrame;
int _PenumbraCascadeCount;
float4 _PenumbraAtlasTexelSize;
float4 _PenumbraSplitSphereSquaredRadii;
float4 _PenumbraSplitSpheres[4];
float4 _PenumbraTileOffsetScale[4];
float4 _PenumbraTileScales[4];
float4x4 _PenumbraWorldToShadow[5];
float4 _PenumbraCascadeBlend; // x: border between cascades, share of a split sphere's radius; y: 1 mixes, 0 dithers

#if defined(PENUMBRA_SPOT_LIGHT)
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    const float4x4 worldToShadow = _PenumbraWorldToShadow[0];
    const SpotCoordinate coordinate = ProjectOntoSpotMap(positionWS, worldToShadow, _PenumbraTileOffsetScale[0]);
    if (!coordinate.covered) return 1.0;

    ShadowReceiver receiver;
    receiver.shadowCoord = coordinate.shadowCoord;
    receiver.depthGradient = ReceiverPlaneInPerspective(normalWS, worldToShadow, coordinate.shadowCoord);
    receiver.rotation = DiskRotation(pixel, _PenumbraNoiseFrame);

    // Filters for spot lights make their own scales.
    ShadowTile tile;
    tile.offsetScale = _PenumbraTileOffsetScale[0];
    tile.atlasTexelSize = _PenumbraAtlasTexelSize;
    tile.uvPerMetre = 0.0;
    tile.depthPerMetre = 0.0;
    tile.depthToRadial = 0.0;
    tile.radialToDepth = 0.0;
    return ResolveTechnique(receiver, tile, 0);
}
#else
float VisibilityInCascade(float3 positionWS, float3 normalWS, float2 pixel, int cascade)
{
    const float4x4 worldToShadow = _PenumbraWorldToShadow[cascade];
    ShadowReceiver receiver;
    receiver.shadowCoord = mul(worldToShadow, float4(positionWS, 1.0)).xyz;
    receiver.depthGradient = ReceiverPlaneFromNormal(normalWS, worldToShadow);
    receiver.rotation = DiskRotation(pixel, _PenumbraNoiseFrame);

    ShadowTile tile;
    tile.offsetScale = _PenumbraTileOffsetScale[cascade];
    tile.atlasTexelSize = _PenumbraAtlasTexelSize;
    tile.uvPerMetre = _PenumbraTileScales[cascade].x;
    tile.depthPerMetre = _PenumbraTileScales[cascade].y;
    tile.depthToRadial = _PenumbraTileScales[cascade].z;
    tile.radialToDepth = _PenumbraTileScales[cascade].w;
    return ResolveTechnique(receiver, tile, cascade);
}

float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    CascadeSpheres spheres;
    spheres.centre0 = _PenumbraSplitSpheres[0].xyz;
    spheres.centre1 = _PenumbraSplitSpheres[1].xyz;
    spheres.centre2 = _PenumbraSplitSpheres[2].xyz;
    spheres.centre3 = _PenumbraSplitSpheres[3].xyz;
    spheres.squaredRadii = _PenumbraSplitSphereSquaredRadii;
    const int cascade = SelectCascade(positionWS, spheres, _PenumbraCascadeCount);
    if (cascade >= _PenumbraCascadeCount) return 1.0;

    float next = NextCascadeWeight(positionWS, spheres, cascade, _PenumbraCascadeCount, _PenumbraCascadeBlend.x);
    if (_PenumbraCascadeBlend.y < 0.5) next = next > CascadeNoise(pixel, _PenumbraNoiseFrame) ? 1.0 : 0.0;
    float visibility = 0.0;
    // A loop, so that the technique is compiled once.
    for (int i = 0; i < 2; ++i)
    {
        const float weight = i == 0 ? 1.0 - next : next;
        if (weight > 0.0) visibility += weight * VisibilityInCascade(positionWS, normalWS, pixel, cascade + i);
    }
    return visibility;
}
#endif
#endif

// One receiver's answer into the buffers.
void Resolve(uint index, float2 pixel)
{
    const float4 position = _PenumbraReceiverPositionWS[index];
    float visibility = 1.0;
    if (position.w > 0.0)
    {
        visibility = ShadowVisibility(position.xyz, _PenumbraReceiverNormalWS[index].xyz, pixel);
    }
    _PenumbraVisibility[index] = visibility;
}

#if defined(PENUMBRA_ADAPTER)
// A user's function runs where it ran in its engine: in a fragment shader, whose derivatives are those of the picture's
// pixels. What the target holds is not read.
float4 ResolveFragment(float4 position : SV_Position) : SV_Target
{
    const int2 pixel = min(int2(position.xy), _PenumbraImageSize - 1);
    Resolve(uint(pixel.y) * uint(_PenumbraImageSize.x) + uint(pixel.x), position.xy);
    return 0.0;
}
#else
[numthreads(8, 8, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    if (any(int2(id.xy) >= _PenumbraImageSize)) return;
    Resolve(id.y * uint(_PenumbraImageSize.x) + id.x, float2(id.xy) + 0.5);
}
#endif
