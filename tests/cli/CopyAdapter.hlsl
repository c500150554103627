// Declares what the harness gives, and calls the copy of a technique as
// tools/measurement/resolve/shaders/Resolve.hlsl calls a technique.
#include "Copied.hlsl"
#include "Core/CascadeSelection.hlsl"
#include "Core/Noise.hlsl"
int _PenumbraNoiseFrame;
int _PenumbraCascadeCount;
float4 _PenumbraAtlasTexelSize;
float4 _PenumbraSplitSpheres[4];
float4 _PenumbraTileOffsetScale[4];
float4 _PenumbraTileScales[4];
float4x4 _PenumbraWorldToShadow[5];
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    CascadeSpheres spheres;
    spheres.centre0 = _PenumbraSplitSpheres[0].xyz;
    spheres.centre1 = _PenumbraSplitSpheres[1].xyz;
    spheres.centre2 = _PenumbraSplitSpheres[2].xyz;
    spheres.centre3 = _PenumbraSplitSpheres[3].xyz;
    spheres.squaredRadii = float4(_PenumbraSplitSpheres[0].w, _PenumbraSplitSpheres[1].w, _PenumbraSplitSpheres[2].w,
                                  _PenumbraSplitSpheres[3].w);
    spheres.squaredRadii *= spheres.squaredRadii;
    const int cascade = SelectCascade(positionWS, spheres, _PenumbraCascadeCount);
    if (cascade >= _PenumbraCascadeCount) return 1.0;
    ShadowReceiver receiver;
    receiver.shadowCoord = mul(_PenumbraWorldToShadow[cascade], float4(positionWS, 1.0)).xyz;
    receiver.depthGradient = ReceiverPlaneFromNormal(normalWS, _PenumbraWorldToShadow[cascade]);
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
