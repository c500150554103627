// Penumbra: four moments of depth, as they are stored.
//
// Computes:   z, z^2, z^3, z^4 of a depth z in [-1, 1], transformed to four values in [0, 1] that use the range of an
//             integer format better; and back.
// Source:     Peters and Klein, "Moment Shadow Mapping", I3D 2015, section 3.3: of the affine transforms of the odd and
//             of the even moments that keep to [0, 1], those with the largest determinant. Odd: (3 z - 4 z^3) / 2 + 1/2
//             and (sqrt(3) z - 4 sqrt(3) / 9 z^3) / 2 + 1/2; even: 4 z^2 - 4 z^4 and z^4.
// Inputs:     stored shadow-map depths, either direction; of the way back, means of the stored values.
// Cost:       no fetches.
// Guarantees: finite; values in [0, 1]. The transform is affine: means may be taken before the way back.
// Use it:     for what is written into a map of four moments. In formats of floats, too: one filter serves both.
#ifndef PENUMBRA_FOUR_MOMENTS_HLSL
#define PENUMBRA_FOUR_MOMENTS_HLSL

#include "DepthMoments.hlsl"

float4 StoredMoments(float storedDepth)
{
    const float z = 2.0 * CentredDepth(SanitizeMapDepth(storedDepth));
    const float square = z * z;
    const float cube = z * square;
    return float4(0.5 + 1.5 * z - 2.0 * cube, 4.0 * square - 4.0 * square * square,
                  0.5 + 0.8660254 * z - 0.38490018 * cube, square * square);
}

float4 MomentsOf(float4 stored)
{
    // Inverse of the odd transform's ((3/2, -2), (sqrt(3)/2, -2 sqrt(3)/9)).
    const float2 odd = stored.xz - 0.5;
    const float first = -0.33333333 * odd.x + 1.7320508 * odd.y;
    const float third = -0.75 * odd.x + 1.2990381 * odd.y;
    return float4(first, 0.25 * stored.y + stored.w, third, stored.w);
}

#endif
