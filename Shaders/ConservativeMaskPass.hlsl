// Penumbra: a penumbra mask of the main light that misses no penumbra of the filter.
//
// Computes:   for each 4 x 4 pixels whether PCSS by angular diameter gives 1 at all of them, 0 at all of them, or may
//             give anything, a quarter of the screen's size.
// Source:     Filters/Decisions/GroupDecision.hlsl.
// Inputs:     those of ScreenPass.hlsl and Pipelines/Urp.hlsl; _PenumbraDepthPlanesTexture: of DepthPlanePasses.hlsl,
//             with mip levels; _PenumbraPcssAngularParameters0 and 1.
// Cost:       per block, 16 surfaces from the camera's depth (5 fetches each, up to 9 at edges) and the planes that
//             Filters/Decisions/GroupDecision.hlsl reads; fewer where the first pixels are of different cascades.
// Guarantees: a value of Screen/PenumbraMask.hlsl, kMaskAllDark, kMaskAllLit or kMaskFilter; 8 bits tell them apart.
//             Resolve gives the same picture with it as without, to the last bit where programs compute the same
//             floats.
// Use it:     before Resolve with _PENUMBRA_PCSS; without a dilation, the light's cones are in it. Not:
//             where raw depths cannot be gathered (OpenGL, WebGL), or without the keyword: there it says kMaskFilter
//             everywhere.
#ifndef PENUMBRA_CONSERVATIVE_MASK_PASS_HLSL
#define PENUMBRA_CONSERVATIVE_MASK_PASS_HLSL

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Core/RowOrder.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"
#include "../ShaderLibrary/Pipelines/TechniqueByKeyword.hlsl"
#include "../ShaderLibrary/Screen/PenumbraMask.hlsl"

#if defined(PENUMBRA_WITHOUT_GATHER) || !defined(_PENUMBRA_PCSS)

float4 ConservativeMask(ScreenVaryings input) : SV_Target
{
    return kMaskFilter;
}

#else

#include "../ShaderLibrary/Filters/Decisions/GroupDecision.hlsl"

TEXTURE2D(_PenumbraDepthPlanesTexture);

// The pixels of a block that the map covers, in one cascade, and whether the block's other pixels are lit without it.
struct MaskBlock
{
    ReceiverGroup group;
    ShadowTile tile;
    int cascade;
    bool anyCovered;
    bool anyOutside;
    bool oneCascade;
};

MaskBlock JoinPixel(MaskBlock block, PenumbraMainLight shadow)
{
    MaskBlock joined = block;
    const QuadReceiver receiver = PrepareQuads(shadow.receiver, shadow.tile);
    if (!block.anyCovered)
    {
        joined.group = GroupOf(receiver);
        joined.tile = shadow.tile;
        joined.cascade = shadow.cascade;
        joined.anyCovered = true;
    }
    else
    {
        joined.oneCascade = block.oneCascade && shadow.cascade == block.cascade;
        joined.group = JoinGroup(block.group, receiver);
    }
    return joined;
}

MaskBlock EmptyMaskBlock()
{
    QuadReceiver nowhere;
    nowhere.bounds.minimum = float2(0.0, 0.0);
    nowhere.bounds.maximum = float2(0.0, 0.0);
    nowhere.texelSize = float2(0.0, 0.0);
    nowhere.centre = float2(0.0, 0.0);
    nowhere.depth = kFarthestDepth;
    nowhere.gradient = float2(0.0, 0.0);
    nowhere.inPerspective = false;
    nowhere.awayFromAxis = float2(0.0, 0.0);
    MaskBlock block;
    block.group = GroupOf(nowhere);
    block.tile = PenumbraMainLightTile(_MainLightWorldToShadow[0], 0, 1, _PenumbraMainLightParams.y);
    block.cascade = 0;
    block.anyCovered = false;
    block.anyOutside = false;
    block.oneCascade = true;
    return block;
}

MaskBlock ReadMaskBlock(int2 index, ScreenView view)
{
    MaskBlock block = EmptyMaskBlock();
    UNITY_LOOP
    for (int i = 0; i < kMaskBlock * kMaskBlock && block.oneCascade; ++i)
    {
        const int2 pixel = index * kMaskBlock + PlaceInRows(i, kMaskBlock);
        if (any(pixel >= int2(view.size.xy))) continue;
        const CameraSurface surface = ReadCameraSurface(_CameraDepthTexture, view, pixel);
        const PenumbraMainLight shadow = PreparePenumbraMainLightTap(surface.positionWS, surface.normalWS);
        // In a border the filter reads the next cascade at some pixels. That one may cover them where their own does
        // not.
        const bool inBorder = surface.seen && PenumbraMainLightInBorder(surface.positionWS, shadow.cascade);
        block.oneCascade = block.oneCascade && !inBorder;
        if (surface.seen && shadow.covered) block = JoinPixel(block, shadow);
        else block.anyOutside = true;
    }
    return block;
}

float4 ConservativeMask(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const MaskBlock block = ReadMaskBlock(int2(input.positionCS.xy), ViewOfThisEye());
    if (!block.oneCascade) return kMaskFilter;
    if (!block.anyCovered) return kMaskAllLit;
    const float decided = DecideAngular(_PenumbraDepthPlanesTexture, block.group, ConeScalesOf(block.tile),
                                        PenumbraPcssAngular(), !block.anyOutside);
    if (decided < 0.0) return kMaskFilter;
    return decided > 0.5 ? kMaskAllLit : kMaskAllDark;
}

#endif

#endif
