// Reads one number of a block of a level: of its planes, or half of the bits of one of its cells. It is no filter for
// shadows: every number is compared bit by bit.
#include "Core/ShadowStructs.hlsl"
struct ReadBlockParameters { int level; int channel; };
ReadBlockParameters UnpackReadBlockParameters(float4 packed0)
{
    ReadBlockParameters parameters;
    parameters.level = int(packed0.x);
    parameters.channel = int(packed0.y);
    return parameters;
}
int2 BlockOf(ShadowReceiver receiver, ShadowTile tile, int level)
{
    return int2(receiver.shadowCoord.xy * tile.atlasTexelSize.zw * exp2(-2.0 - float(level)));
}
float HalfOfCell(uint4 cells, int half)
{
    return float((cells[half >> 1] >> (16 * (half & 1))) & 0xFFFFu);
}
// The first level is a texture of its own.
float ReadBlock(TEXTURE2D(planes), Texture2D<uint4> spreads, TEXTURE2D(coarsePlanes),
                Texture2D<uint4> coarseSpreads, ShadowReceiver receiver, ShadowTile tile,
                ReadBlockParameters parameters)
{
    const int2 block = BlockOf(receiver, tile, parameters.level);
    const int channel = parameters.channel;
    if (parameters.level == 0)
    {
        if (channel < 4) return LOAD_TEXTURE2D(planes, block)[channel];
        return HalfOfCell(LOAD_TEXTURE2D(spreads, block), channel - 4);
    }
    const int level = parameters.level - 1;
    if (channel < 4) return LOAD_TEXTURE2D_LOD(coarsePlanes, block, level)[channel];
    return HalfOfCell(LOAD_TEXTURE2D_LOD(coarseSpreads, block, level), channel - 4);
}
