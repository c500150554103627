// Reads a map of ranges or moments, a texel of a level for each receiver. It is no filter for
// shadows: every number is known.
#include "Core/ShadowStructs.hlsl"
struct ReadRangeParameters { int level; int channel; };
ReadRangeParameters UnpackReadRangeParameters(float4 packed0)
{
    ReadRangeParameters parameters;
    parameters.level = int(packed0.x);
    parameters.channel = int(packed0.y);
    return parameters;
}
float ReadRange(TEXTURE2D(ranges), ShadowReceiver receiver, ShadowTile tile, ReadRangeParameters parameters)
{
    const float2 texel = receiver.shadowCoord.xy * tile.atlasTexelSize.zw * exp2(-2.0 - float(parameters.level));
    const float4 read = LOAD_TEXTURE2D_LOD(ranges, int2(texel), parameters.level);
    if (parameters.channel == 0) return read.x;
    if (parameters.channel == 1) return read.y;
    return parameters.channel == 2 ? read.z : read.w;
}
