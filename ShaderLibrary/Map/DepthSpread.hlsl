// Penumbra: mean and standard deviation of depths over square cells of the shadow map.
//
// Computes:   DepthSpread of 2 x 2 texels, and of four cells; both numbers in 32 bits.
// Source:     the law of total variance: the variance of a whole is the mean of its parts' variances plus the variance
//             of their means.
// Inputs:     stored depths in [0, 1], either direction, sanitised.
// Cost:       no fetches.
// Guarantees: finite. 16 bits each: the mean to within 1/131070, the deviation, which is at most 1/2, to within
//             1/262140; four equal depths have a deviation of exactly 0.
// Use it:     in levels of cells twice as wide each, read without filtering: a filtered deviation is not that of the
//             filtered depths.
#ifndef PENUMBRA_DEPTH_SPREAD_HLSL
#define PENUMBRA_DEPTH_SPREAD_HLSL

struct DepthSpread
{
    float mean;
    float deviation;
};

uint PackSpread(DepthSpread spread)
{
    const uint mean = uint(min(max(spread.mean, 0.0), 1.0) * 65535.0 + 0.5);
    const uint deviation = uint(min(max(2.0 * spread.deviation, 0.0), 1.0) * 65535.0 + 0.5);
    return (mean << 16) | deviation;
}

DepthSpread UnpackSpread(uint packed)
{
    DepthSpread spread;
    spread.mean = float(packed >> 16) / 65535.0;
    spread.deviation = float(packed & 0xffffu) / 131070.0;
    return spread;
}

DepthSpread SpreadOfFour(float4 depths)
{
    DepthSpread spread;
    spread.mean = 0.25 * ((depths.x + depths.y) + (depths.z + depths.w));
    const float4 away = depths - spread.mean;
    spread.deviation = sqrt(0.25 * dot(away, away));
    return spread;
}

// means and deviations are those of the four cells.
DepthSpread JoinSpreads(float4 means, float4 deviations)
{
    DepthSpread whole = SpreadOfFour(means);
    whole.deviation = sqrt(whole.deviation * whole.deviation + 0.25 * dot(deviations, deviations));
    return whole;
}

// cells holds the packed spreads of four cells.
uint JoinPackedSpreads(uint4 cells)
{
    float4 means, deviations;
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i)
    {
        const DepthSpread spread = UnpackSpread(cells[i]);
        means[i] = spread.mean;
        deviations[i] = spread.deviation;
    }
    return PackSpread(JoinSpreads(means, deviations));
}

#endif
