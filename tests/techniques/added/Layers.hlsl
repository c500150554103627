// The filter of Layers.technique.json: every surface before the receiver takes a share of the light that is left.
#include "Core/DepthConvention.hlsl"
#include "Core/ShadowStructs.hlsl"
#include "Parameters/LayersParameters.hlsl"
float FilterLayers(TEXTURE2D(nearest), TEXTURE2D(layers), ShadowReceiver receiver, ShadowTile tile,
                   LayersParameters parameters)
{
    const int2 texel = int2(receiver.shadowCoord.xy * tile.atlasTexelSize.zw);
    if (DepthGap(LOAD_TEXTURE2D(nearest, texel).x, receiver.shadowCoord.z) <= 0.0) return 1.0;
    return pow(1.0 - parameters.opacity, LOAD_TEXTURE2D(layers, texel).x);
}
