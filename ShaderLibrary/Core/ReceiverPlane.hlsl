// Penumbra: the receiver's depth next to the pixel.
//
// Computes:   how stored depth changes along the receiver's plane, per unit of atlas UV, so that a tap next to
//             the pixel is compared with the depth of the surface there and not with the pixel's.
// Source:     Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", GDC 2006 (the inverse Jacobian of the
//             shadow coordinate on the screen). From a normal: the plane n.x = const, transformed by the matrix.
// Inputs:     shadow coordinates: atlas UV and stored depth; normalWS: unit, world space; worldToShadow: maps
//             column vectors (world metres, 1) to atlas UV and stored depth.
// Cost:       no fetches.
// Guarantees: finite, and no steeper than kLargestGradient. Where the screen derivatives of the UV are (nearly)
//             parallel, or the plane is edge-on to the light, the result is 0: no plane is known. Degeneracy is
//             judged relative to the derivatives' own lengths, so it does not depend on resolution.
// Use it:     from a normal if there is one: it is exact, while derivatives are wrong across depth edges.
#ifndef PENUMBRA_RECEIVER_PLANE_HLSL
#define PENUMBRA_RECEIVER_PLANE_HLSL

#include "FloatBits.hlsl"

// Steepest slope that is accepted, stored depth per atlas UV. One texel of a 4096-texel map then changes depth by
// a quarter of the range.
static const float kLargestGradient = 1024.0;

// sin of the smallest angle between screen derivatives, or between plane and light, that is accepted: about
// 0.06 degrees. Below it, rounding errors of the shadow coordinates dominate the slope.
static const float kSmallestSine = 1e-3;

float2 BoundGradient(float2 gradient)
{
    const float steepest = max(abs(gradient.x), abs(gradient.y));
    if (!HasFiniteBits(gradient.x) || !HasFiniteBits(gradient.y)) return float2(0.0, 0.0);
    return steepest > kLargestGradient ? gradient * (kLargestGradient / max(steepest, kLargestGradient)) : gradient;
}

// The plane from the changes of the shadow coordinate to the next pixels right and down, as ddx and ddy of shadowCoord
// are. Texels in place of atlas UV give the slope per texel.
//
//     | dz/dx |   | du/dx  dv/dx | | dz/du |
//     | dz/dy | = | du/dy  dv/dy | | dz/dv |
float2 ReceiverPlaneFromDerivatives(float3 alongX, float3 alongY)
{
    const float lengthX = max(abs(alongX.x), abs(alongX.y));
    const float lengthY = max(abs(alongY.x), abs(alongY.y));
    if (!(lengthX > 1e-20) || !(lengthY > 1e-20)) return float2(0.0, 0.0);
    // Rows scaled to about unit length: neither product can overflow or vanish, and the determinant is the sine
    // of the angle between them, up to a factor of two.
    const float3 x = alongX / lengthX;
    const float3 y = alongY / lengthY;
    const float determinant = x.x * y.y - x.y * y.x;
    if (!(abs(determinant) > kSmallestSine)) return float2(0.0, 0.0);
    const float2 gradient = float2(y.y * x.z - x.y * y.z, x.x * y.z - y.x * x.z) / determinant;
    return BoundGradient(gradient);
}

// The plane from the surface's normal, under a light whose rays are parallel. World directions that keep atlas UV u, v
// or depth are needed: the rows of an orthographic light's matrix are orthogonal, so n.t = 0 for t = du row0/|row0|^2 +
// dv row1/|row1|^2 + dz row2/|row2|^2.
float2 ReceiverPlaneFromNormal(float3 normalWS, float4x4 worldToShadow)
{
    const float3 row0 = worldToShadow[0].xyz;
    const float3 row1 = worldToShadow[1].xyz;
    const float3 row2 = worldToShadow[2].xyz;
    const float u = dot(normalWS, row0) / max(dot(row0, row0), 1e-30);
    const float v = dot(normalWS, row1) / max(dot(row1, row1), 1e-30);
    const float squaredRow2 = max(dot(row2, row2), 1e-30);
    const float along = dot(normalWS, row2);
    // along / |row2| is the sine of the angle between plane and light.
    const bool known = along * along > kSmallestSine * kSmallestSine * squaredRow2;
    // Without a normal `along` is a constant 0, and compilers warn of a division by it although its result is not used.
    const float2 gradient = -float2(u, v) * (squaredRow2 / (known ? along : 1.0));
    return known ? BoundGradient(gradient) : float2(0.0, 0.0);
}

// The plane under a light in perspective, whose matrix takes the receiver to shadowCoord after division by w. Near the
// receiver shadowCoord moves by J = (row - shadowCoord row3) / w per metre, and the gradient g is such that J2 - g.x J0
// - g.y J1 has the normal's direction: two determinants over a third, which is the sine of the angle between plane and
// ray times |J0 x J1|. w drops out.
float2 ReceiverPlaneInPerspective(float3 normalWS, float4x4 worldToShadow, float3 shadowCoord)
{
    const float3 alongU = worldToShadow[0].xyz - shadowCoord.x * worldToShadow[3].xyz;
    const float3 alongV = worldToShadow[1].xyz - shadowCoord.y * worldToShadow[3].xyz;
    const float3 alongDepth = worldToShadow[2].xyz - shadowCoord.z * worldToShadow[3].xyz;
    const float3 ray = cross(alongU, alongV);
    const float facing = dot(normalWS, ray);
    if (!(facing * facing > kSmallestSine * kSmallestSine * max(dot(ray, ray), 1e-30))) return float2(0.0, 0.0);
    const float2 gradient = float2(dot(normalWS, cross(alongDepth, alongV)), dot(normalWS, cross(alongU, alongDepth)));
    return BoundGradient(gradient / facing);
}

// The receiver plane's stored depth `offset` (atlas UV) away from the receiver, within [0, 1].
float ReceiverPlaneDepth(float receiverDepth, float2 gradient, float2 offset)
{
    return min(max(receiverDepth + dot(gradient, offset), 0.0), 1.0);
}

#endif
