// Penumbra: points spread over the unit disk.
//
// Computes:   the i-th of N points of a Fibonacci spiral (uniform or denser at the centre), of a Vogel spiral, and of
//             Poisson sets; rotation of a point.
// Source:     Vogel, "A better way to construct the sunflower head" (1979): point i of N at radius
//             sqrt((i + 1/2) / N), turned by i golden angles. Poisson sets: `penumbra tables`.
// Inputs:     index 0 .. N - 1; N 1 .. kLargestSampleCount. PENUMBRA_UNLIMITED: counts up to 4096, for reference
//             results, with points computed instead of read from a table.
// Cost:       no fetches.
// Guarantees: radius < 1 for the spirals, <= 1 for the Poisson sets. Every prefix of the golden-angle directions is
//             well spread, so any N can be used. The golden angle is taken modulo a turn in integers: no accuracy is
//             lost at high indices.
// Use it:     Fibonacci where N is a parameter; Poisson for comparison with existing filters.
#ifndef PENUMBRA_DISK_HLSL
#define PENUMBRA_DISK_HLSL

#include "DiskTables.hlsl"
#include "FloatBits.hlsl"

#if defined(PENUMBRA_UNLIMITED)
static const int kLargestSampleCount = 4096;
#else
static const int kLargestSampleCount = 128;
#endif

int BoundedSampleCount(int count)
{
    return min(max(count, 1), kLargestSampleCount);
}

// (cos, sin) of `index` golden angles, 2 pi (2 - golden ratio) each.
float2 GoldenDirection(int index)
{
    // 2^32 (2 - golden ratio) = 1640531527 - 0.4333: the integer constant is too large by 0.4333, an error that grows
    // with the index. Subtracting 7/16 of the index compensates it.
    const uint turn = uint(index) * 1640531527u - ((uint(index) * 7u) >> 4);
    const float angle = float(turn >> 8) * (6.2831853 / 16777216.0);
    return float2(cos(angle), sin(angle));
}

float2 FibonacciDirection(int index)
{
#if defined(PENUMBRA_UNLIMITED)
    return GoldenDirection(index);
#else
    return kPenumbraFibonacciDirections[min(max(index, 0), 63)];
#endif
}

// Radius of point `index` of `count`. clump 1: uniform over the area. clump 2: uniform over the radius (density 1/r).
// abs() costs nothing and tells compilers that the base of pow() is not negative.
float FibonacciRadius(int index, int count, float clump)
{
    return pow(abs((float(index) + 0.5) / float(count)), 0.5 * clump);
}

// Radius of point `index` of `count` with the same number of points per octave of radius from `innermost` to
// `outermost` (both > 0): a density of 1/r^2, which samples the centre well however far out the last point is.
float GeometricRadius(int index, int count, float innermost, float outermost)
{
    const float ratio = max(outermost / innermost, 1.0);
    return min(innermost * pow(ratio, (float(index) + 0.5) / float(count)), outermost);
}

float2 FibonacciDisk(int index, int count, float clump)
{
    return FibonacciDirection(index) * FibonacciRadius(index, count, clump);
}

float2 VogelDisk(int index, int count)
{
    return GoldenDirection(index) * sqrt((float(index) + 0.5) / float(count));
}

// Size of the smallest Poisson set that has at least `wanted` points, or else of the largest set.
int PoissonSetSize(int wanted)
{
#if defined(PENUMBRA_UNLIMITED)
    return BoundedSampleCount(wanted);
#else
    return wanted <= 25 ? 25 : wanted <= 32 ? 32 : wanted <= 64 ? 64 : wanted <= 100 ? 100 : 128;
#endif
}

// Point of the Poisson set with `count` points; count as PoissonSetSize returns it.
float2 PoissonDisk(int index, int count)
{
#if defined(PENUMBRA_UNLIMITED)
    return VogelDisk(index, count);
#else
    const int last = max(count - 1, 0);
    const int i = min(max(index, 0), last);
    float2 disk;
    if (count <= 25) disk = kPenumbraPoisson25[min(i, 24)];
    else if (count <= 32) disk = kPenumbraPoisson32[min(i, 31)];
    else if (count <= 64) disk = kPenumbraPoisson64[min(i, 63)];
    else if (count <= 100) disk = kPenumbraPoisson100[min(i, 99)];
    else disk = kPenumbraPoisson128[min(i, 127)];
    return disk;
#endif
}

// `rotation` is (cos, sin). Rotates, never scales, when it is a unit vector.
float2 RotateDisk(float2 disk, float2 rotation)
{
    return float2(disk.x * rotation.x - disk.y * rotation.y, disk.x * rotation.y + disk.y * rotation.x);
}

// A unit rotation from any input; a vector that is not finite or has no length gives no rotation.
float2 UnitRotation(float2 rotation)
{
    const float2 bounded = min(max(FiniteOr(rotation, float2(1.0, 0.0)), -2.0), 2.0);
    const float squaredLength = dot(bounded, bounded);
    return squaredLength > 1e-6 ? bounded * rsqrt(squaredLength) : float2(1.0, 0.0);
}

#endif
