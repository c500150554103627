// Penumbra: four texels from one gather, each tested at its own centre.
//
// Computes:   depths of a 2 x 2 quad, which of them block the receiver, and their bilinear weights.
//
//                 w | z      order of a gather's components around the corner
//                 --+--      the four texels share
//                 x | y
//
// Source:     the receiver's plane: Isidoro, GDC 2006. A comparison sampler has one reference depth for four texels;
//             gathering first costs the same fetch and gives each texel its own.
// Inputs:     shadow map (raw reads), point sampler; texel coordinates.
// Cost:       1 fetch per quad.
// Guarantees: reads no texel outside the tile; NaN texels do not block; all results finite. The quad is addressed at
//             its corner, half a texel away from where rounding could select another quad.
// Use it:     in kernels wider than a texel. Needs gather (Shader Model 4.1, OpenGL ES 3.1).
#ifndef PENUMBRA_TEXEL_QUAD_HLSL
#define PENUMBRA_TEXEL_QUAD_HLSL

#include "../../Platform/Platform.hlsl"
#include "../../Core/DepthConvention.hlsl"
#include "../../Core/FloatBits.hlsl"
#include "../../Core/Penumbra.hlsl"
#include "../../Core/ReceiverPlane.hlsl"
#include "../../Core/ShadowStructs.hlsl"
#include "../../Core/SpotLight.hlsl"
#include "../../Core/TileBounds.hlsl"

// The distance from a sample to the centre of the farthest texel of its quad, also where the tile's edge moves the
// quad.
static const float kSampleReachTexels = 2.25;

struct QuadReceiver
{
    TileBounds bounds;
    float2 texelSize; // atlas UV
    float2 centre;    // texel coordinates
    float depth;
    float2 gradient;  // stored depth per texel
    bool inPerspective;  // whether awayFromAxis counts: with the sun's maps it costs nothing
    float2 awayFromAxis; // direction that Core/SpotLight.hlsl explains
};

// The light's cone above the receiver. largestOffset 0 makes it a plain disc.
struct LightCone
{
    ConeScales scales;
    float slackTexels;
    float largestOffset; // stored depth
};

struct TexelQuad
{
    float4 gap;        // how much nearer to the light than the receiver each texel lies, stored depth
    float4 abovePlane; // the same above the receiver's plane at the texel's centre
    float4 radius;     // distance from the receiver to the texel's centre, texels, as the light's disc has it
    float4 blocking;   // 1 where the texel hides light, else 0
    float4 weight;     // bilinear weight at the sample's position
};

// The result of a blocker search.
struct BlockerEstimate
{
    float gap;   // mean gap, stored depth
    float count; // number of texels that block; 0: no estimate
};

QuadReceiver PrepareQuads(ShadowReceiver receiver, ShadowTile tile)
{
    QuadReceiver prepared;
    prepared.bounds = BoundsInTexels(tile);
    prepared.texelSize = 1.0 / max(FiniteOr(tile.atlasTexelSize.zw, float2(1.0, 1.0)), 1.0);
    prepared.centre = TexelCoordinates(receiver.shadowCoord.xy, tile);
    prepared.depth = SanitizeReceiverDepth(receiver.shadowCoord.z);
    prepared.gradient = BoundGradient(receiver.depthGradient) * prepared.texelSize;
    prepared.inPerspective = false;
    prepared.awayFromAxis = float2(0.0, 0.0);
    return prepared;
}

// The place in the map of a point of the disc around the receiver, texels: it is stretched under a spot light.
float2 OffsetInMap(float2 offset, QuadReceiver receiver)
{
    if (!receiver.inPerspective) return offset;
    return StretchAwayFromAxis(offset, receiver.awayFromAxis);
}

float4 BilinearWeights(float2 texels, float2 corner)
{
    const float2 f = min(max(texels - corner + 0.5, 0.0), 1.0);
    return float4((1.0 - f.x) * f.y, f.x * f.y, f.x * (1.0 - f.y), (1.0 - f.x) * (1.0 - f.y));
}

// 1 where a texel lies above the receiver's plane at its own centre and within the cone, else 0.
float4 TexelsInCone(float4 gap, float4 abovePlane, float4 radius, LightCone cone)
{
    const float4 offset = min(max(radius - cone.slackTexels, 0.0) * cone.scales.depthPerTexel, cone.largestOffset);
    return float4(abovePlane.x > 0.0 && gap.x > offset.x, abovePlane.y > 0.0 && gap.y > offset.y,
                  abovePlane.z > 0.0 && gap.z > offset.z, abovePlane.w > 0.0 && gap.w > offset.w);
}

TexelQuad ReadQuad(TEXTURE2D_PARAM(shadowMap, sampler_point), QuadReceiver receiver, LightCone cone, float2 texels)
{
    const float2 corner = ClampQuadCorner(texels, receiver.bounds);
    const float4 mapDepth = SanitizeMapDepth(GATHER_RED_TEXTURE2D(shadowMap, sampler_point,
                                                                  corner * receiver.texelSize));
    const float2 away = corner - receiver.centre;
    const float4 x = away.x + float4(-0.5, 0.5, 0.5, -0.5);
    const float4 y = away.y + float4(0.5, 0.5, -0.5, -0.5);
    const float4 plane = KeepBehindNearPlane(receiver.depth + receiver.gradient.x * x + receiver.gradient.y * y);

    TexelQuad quad;
    if (receiver.inPerspective) quad.radius = sqrt(SquaredRadiusFacingLight(x, y, receiver.awayFromAxis));
    else quad.radius = sqrt(x * x + y * y);
    quad.gap = DepthGap(mapDepth, float4(receiver.depth, receiver.depth, receiver.depth, receiver.depth));
    quad.abovePlane = DepthGap(mapDepth, plane);
    quad.blocking = TexelsInCone(quad.gap, quad.abovePlane, quad.radius, cone);
    quad.weight = BilinearWeights(texels, corner);
    return quad;
}

#endif
