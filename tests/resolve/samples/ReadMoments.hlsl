// Reads a map of moments, a texel for each receiver. It is no filter for shadows: every number is known.
#include "Core/ShadowStructs.hlsl"
struct ReadMomentsParameters { int channel; };
ReadMomentsParameters UnpackReadMomentsParameters(float4 packed0)
{
    ReadMomentsParameters parameters;
    parameters.channel = int(packed0.x);
    return parameters;
}
float ReadMoments(TEXTURE2D(moments), ShadowReceiver receiver, ShadowTile tile, ReadMomentsParameters parameters)
{
    const float4 read = LOAD_TEXTURE2D_LOD(moments, int2(receiver.shadowCoord.xy * tile.atlasTexelSize.zw), 0);
    return 0.5 + (parameters.channel == 0 ? read.x : read.y); // moments are centred, visibilities are not below 0
}
