// Penumbra: the maps of blended casters.
//
// Computes:   BlendedOpacity  1 less the product of what the casters transmit, by the blend state SrcAlpha
//                             OneMinusSrcAlpha: with colour 1 each draw makes 1 - (1 - alpha) (1 - target) of the
//                             target
//             BlendedDepth    their nearest depth
// Source:     Candycat, "Graphics Study: RDR2, shadows" (2021): an opacity mask beside the cascades. The depth is not
//             in it.
// Inputs:     _MainLightShadowmapTexture, of the target's size; CasterMaterial.hlsl; vertex colours, whose alpha
//             particles fade with.
// Cost:       2 fetches for each fragment.
// Guarantees: the mask does not depend on the order of the casters. What lies behind a texel's opaque caster adds
//             nothing to it. Opacities are in [0, 1], also of materials whose numbers make no sense.
// Use it:     into one channel of 8 bits and a depth texture, for casters that the shadow map does not hold.
#ifndef PENUMBRA_OPACITY_PASSES_HLSL
#define PENUMBRA_OPACITY_PASSES_HLSL

#include "CasterMaterial.hlsl"
#include "../ShaderLibrary/Core/DepthConvention.hlsl"
#include "../ShaderLibrary/Core/FloatBits.hlsl"
#include "../ShaderLibrary/Pipelines/Urp.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl"

// This is half a step of 8 bits: what the mask does not hold has no depth.
static const float kSmallestOpacity = 0.5 / 255.0;

struct BlendedAttributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
    float4 colour : COLOR;
};

struct BlendedVaryings
{
    float4 positionCS : SV_POSITION;
    float2 uv : TEXCOORD0;
    float alpha : TEXCOORD1;
};

// The casters have no bias, because no receiver is blended and none shadows itself.
BlendedVaryings BlendedVertex(BlendedAttributes input)
{
    BlendedVaryings output;
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
    output.uv = MaterialCoordinates(input.uv);
    output.alpha = input.colour.a;
    return output;
}

float CasterOpacity(BlendedVaryings input)
{
    const float opacity = BoundedOrLow(MaterialAlpha(input.uv) * input.alpha, 0.0, 1.0);
    const float opaqueDepth = SanitizeMapDepth(LOAD_TEXTURE2D(_MainLightShadowmapTexture, int2(input.positionCS.xy)).x);
    const float depth = min(max(input.positionCS.z, 0.0), 1.0);
    return DepthGap(opaqueDepth, depth) > 0.0 ? 0.0 : opacity;
}

float4 BlendedOpacity(BlendedVaryings input) : SV_Target
{
    return float4(1.0, 1.0, 1.0, CasterOpacity(input));
}

void BlendedDepth(BlendedVaryings input)
{
    clip(CasterOpacity(input) - kSmallestOpacity);
}

#endif
