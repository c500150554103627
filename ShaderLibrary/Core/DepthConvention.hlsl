// Penumbra: the direction of stored depth.
//
// Computes:   comparisons and steps along the light that have the same meaning in both depth conventions.
// Source:     Reed, "Depth Precision Visualized" (2015), for why reversed depth exists.
// Inputs:     stored shadow-map depths in [0, 1]. Conventional: 0 nearest the light, 1 farthest. Reversed
//             (UNITY_REVERSED_Z non-zero): 1 nearest, 0 farthest.
// Cost:       no fetches.
// Guarantees: the only file of the library that tests UNITY_REVERSED_Z. Finite for finite inputs.
// Use it:     wherever two depths are compared. Not: for the camera's eye depth.
#ifndef PENUMBRA_DEPTH_CONVENTION_HLSL
#define PENUMBRA_DEPTH_CONVENTION_HLSL

#if UNITY_REVERSED_Z
static const float kNearestDepth = 1.0;
static const float kFarthestDepth = 0.0;
static const float kTowardLight = 1.0;
#else
static const float kNearestDepth = 0.0;
static const float kFarthestDepth = 1.0;
static const float kTowardLight = -1.0;
#endif

// The amount by which `mapDepth` lies nearer to the light than `referenceDepth`; negative when it lies behind. Stored
// units.
float DepthGap(float mapDepth, float referenceDepth)
{
    return (mapDepth - referenceDepth) * kTowardLight;
}

float4 DepthGap(float4 mapDepth, float4 referenceDepth)
{
    return (mapDepth - referenceDepth) * kTowardLight;
}

// A surface at equal depth does not block: it is the receiver itself.
bool IsBlocker(float mapDepth, float referenceDepth)
{
    return DepthGap(mapDepth, referenceDepth) > 0.0;
}

// The stored depth `distance` (stored units, >= 0) nearer to the light, not clamped.
float MoveTowardLight(float depth, float distance)
{
    return depth + distance * kTowardLight;
}

// The largest gap that any blocker of the map can have above this depth.
float LargestGap(float depth)
{
    return max(DepthGap(kNearestDepth, depth), 0.0);
}

// Keeps a reference depth strictly behind the near plane. Casters in front of the near plane are drawn at
// kNearestDepth ("pancaking"), so a reference that a bias or a plane moved there must still lie behind them.
float KeepBehindNearPlane(float depth)
{
    const float step = 5.9604645e-8; // 2^-24: half the spacing of floats below 1
#if UNITY_REVERSED_Z
    return min(max(depth, 0.0), 1.0 - step);
#else
    return min(max(depth, step), 1.0);
#endif
}

float4 KeepBehindNearPlane(float4 depth)
{
    return float4(KeepBehindNearPlane(depth.x), KeepBehindNearPlane(depth.y), KeepBehindNearPlane(depth.z),
                  KeepBehindNearPlane(depth.w));
}

// The same for depths that may lie beyond the far end of the range.
float4 LimitToNearPlane(float4 depth)
{
#if UNITY_REVERSED_Z
    return min(depth, KeepBehindNearPlane(kNearestDepth));
#else
    return max(depth, KeepBehindNearPlane(kNearestDepth));
#endif
}

#endif
