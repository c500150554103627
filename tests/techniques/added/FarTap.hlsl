// The filter of FarTap.technique.json: one comparison, 16 texels beside the receiver, of which its exits know nothing.
#include "Filters/HardTest.hlsl"
float FilterFarTap(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), ShadowReceiver receiver, ShadowTile tile)
{
    ShadowReceiver beside = receiver;
    beside.shadowCoord.x += 16.0 * tile.atlasTexelSize.x;
    return FilterHard(TEXTURE2D_ARGS(shadowMap, sampler_shadowMap), beside, tile);
}
