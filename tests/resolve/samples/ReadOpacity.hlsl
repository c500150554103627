// Reads the opacity mask, a texel for each receiver. It is no filter for shadows: every number is known.
#include "Core/ShadowStructs.hlsl"
float ReadOpacity(TEXTURE2D(opacityMask), ShadowReceiver receiver, ShadowTile tile)
{
    return LOAD_TEXTURE2D_LOD(opacityMask, int2(receiver.shadowCoord.xy * tile.atlasTexelSize.zw), 0).x;
}
