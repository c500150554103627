// Penumbra: the debug views of the renderer feature, drawn over the camera's picture.
//
// Computes:   a colour for each pixel of the screen: the visibility that receivers read; which cascade covers it; how
//             large a texel of the shadow map is there; how wide the penumbra is; where the mask lets the filter run.
// Source:     Screen/DebugColours.hlsl; the width: Filters/Pcss/PcssAngular.hlsl, for every technique.
// Inputs:     those of ScreenPass.hlsl and Shadows.hlsl as the frame's own passes had them; URP's
//             _ScreenSpaceShadowmapTexture; _PenumbraMaskTexture; _PenumbraDebugParams: x 1 where there is a mask, y 1
//             where the camera draws over another's picture, z 1 where the picture's rows run the other way than those
//             of the frame's textures.
// Cost:       the width: a blocker search; the others: 2 to 7 fetches.
// Guarantees: black on the sky, or nothing over another camera's picture; alpha 1. A width below a
//             texel is blue: a tent filter draws such a penumbra as well.
// Use it:     in the editor and in development builds, by the passes of PenumbraDebugViews.shader.
#ifndef PENUMBRA_DEBUG_PASS_HLSL
#define PENUMBRA_DEBUG_PASS_HLSL

// The blocker search of this technique determines the width.
#define _PENUMBRA_PCSS

#include "ScreenPass.hlsl"
#include "../ShaderLibrary/Shadows.hlsl"
#include "../ShaderLibrary/Core/Penumbra.hlsl"
#include "../ShaderLibrary/Screen/DebugColours.hlsl"
#include "../ShaderLibrary/Screen/PenumbraMask.hlsl"

TEXTURE2D_X(_PenumbraMaskTexture);
float4 _PenumbraDebugParams;

static const float3 kNarrowerThanATexel = float3(0.15, 0.35, 1.0);
static const float3 kFiltered = float3(1.0, 0.72, 0.2);

struct DebugPixel
{
    int2 pixel;
    float visibility;
    CameraSurface surface;
    PenumbraMainLight shadow;
};

// The position of the same pixel in the frame's textures.
float2 TexturePosition(float4 positionCS)
{
    const bool reversed = _PenumbraDebugParams.z > 0.5;
    return float2(positionCS.x, reversed ? _PenumbraScreenSize.y - positionCS.y : positionCS.y);
}

DebugPixel ReadDebugPixel(float4 positionCS)
{
    const ScreenView view = ViewOfThisEye();
    const float2 position = TexturePosition(positionCS);
    DebugPixel here;
    here.pixel = int2(position);
    here.visibility = LOAD_TEXTURE2D_X(_ScreenSpaceShadowmapTexture, here.pixel).x;
    here.surface = ReadCameraSurface(_CameraDepthTexture, view, here.pixel);
    here.shadow = PreparePenumbraMainLight(here.surface.positionWS, here.surface.normalWS, position);
    return here;
}

float4 OnSurface(DebugPixel here, float3 colour)
{
    if (!here.surface.seen && _PenumbraDebugParams.y > 0.5) discard;
    return here.surface.seen ? float4(colour, 1.0) : float4(0.0, 0.0, 0.0, 1.0);
}

// The shadow remains visible in views of other values.
float3 Shaded(DebugPixel here, float3 colour)
{
    return colour * (0.4 + 0.6 * here.visibility);
}

float4 DebugVisibility(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const DebugPixel here = ReadDebugPixel(input.positionCS);
    return OnSurface(here, float3(here.visibility, here.visibility, here.visibility));
}

float4 DebugCascades(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const DebugPixel here = ReadDebugPixel(input.positionCS);
    const int cascade = PenumbraMainLightCascade(here.surface.positionWS, PenumbraMainLightCascadeCount());
    return OnSurface(here, Shaded(here, CascadeColour(here.shadow.covered ? cascade : -1)));
}

float4 DebugShadowTexels(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const DebugPixel here = ReadDebugPixel(input.positionCS);
    if (!here.shadow.covered) return OnSurface(here, Shaded(here, CascadeColour(-1)));
    const float texelMetres = 1.0 / max(ConeScalesOf(here.shadow.tile).texelsPerMetre, 1e-9);
    const float pixels = texelMetres / max(here.surface.metresPerPixel, 1e-9);
    const float2 texels = here.shadow.receiver.shadowCoord.xy * _PenumbraMainLightAtlasTexelSize.zw;
    const float chequer = 0.65 + 0.35 * TexelChequer(texels);
    return OnSurface(here, Shaded(here, chequer * TexelSizeColour(pixels)));
}

// The width in metres; 0 where nothing blocks, and on devices that cannot gather.
float WidthOfPenumbra(PenumbraMainLight shadow)
{
#if defined(PENUMBRA_READS_RAW_DEPTH)
    if (!shadow.covered) return 0.0;
    return PenumbraWidthAngular(TEXTURE2D_ARGS(_MainLightShadowmapTexture, sampler_PenumbraPointClamp),
                                shadow.receiver, shadow.tile,
                                PenumbraPcssAngular());
#else
    return 0.0;
#endif
}

float4 DebugPenumbraWidth(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const DebugPixel here = ReadDebugPixel(input.positionCS);
    const float metres = WidthOfPenumbra(here.shadow);
    const bool inPenumbra = metres > 0.0 && here.visibility > 0.0 && here.visibility < 1.0;
    if (!inPenumbra) return OnSurface(here, 0.35 * Shaded(here, float3(1.0, 1.0, 1.0)));
    const bool resolved = metres * ConeScalesOf(here.shadow.tile).texelsPerMetre >= 1.0;
    return OnSurface(here, resolved ? HeatColour(LengthShare(metres)) : kNarrowerThanATexel);
}

float4 DebugPenumbraMask(ScreenVaryings input) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const DebugPixel here = ReadDebugPixel(input.positionCS);
    bool filtered = true;
    UNITY_BRANCH
    if (_PenumbraDebugParams.x > 0.5)
        filtered = LOAD_TEXTURE2D_X(_PenumbraMaskTexture, MaskBlockOf(here.pixel)).x >= 0.5;
    return OnSurface(here, Shaded(here, filtered ? kFiltered : float3(0.6, 0.6, 0.6)));
}

#endif
