// The filter of Means.technique.json: a mean of depths. It is no filter for shadows: every number of it is known.
#include "Core/ShadowStructs.hlsl"
#include "Parameters/MeansParameters.hlsl"
float FilterMeans(TEXTURE2D(blurred), ShadowReceiver receiver, ShadowTile tile, MeansParameters parameters)
{
    const float2 texel = receiver.shadowCoord.xy * tile.atlasTexelSize.zw * exp2(-float(parameters.level));
    return parameters.scale * LOAD_TEXTURE2D_LOD(blurred, int2(texel), parameters.level).x;
}
