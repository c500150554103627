// The filter of Means.technique.json: a mean of depths. It is no filter for shadows: every number of it is known.
#include "Core/ShadowStructs.hlsl"
struct MeansParameters { int level; float scale; };
MeansParameters UnpackMeansParameters(float4 packed0)
{
    MeansParameters parameters;
    parameters.level = int(packed0.x);
    parameters.scale = packed0.y;
    return parameters;
}
float FilterMeans(TEXTURE2D(blurred), ShadowReceiver receiver, ShadowTile tile, MeansParameters parameters)
{
    const float2 texel = receiver.shadowCoord.xy * tile.atlasTexelSize.zw * exp2(-float(parameters.level));
    return parameters.scale * LOAD_TEXTURE2D_LOD(blurred, int2(texel), parameters.level).x;
}
