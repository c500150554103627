// Penumbra: noise that rotates each pixel's disk.
//
// Computes:   interleaved gradient noise, and a rotation from it.
// Source:     Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014.
// Inputs:     pixel: integer coordinates or pixel centres; frame: index of the frame, any; taken modulo 64.
// Cost:       no fetches.
// Guarantees: noise in [0, 1); the rotation is a unit vector up to rounding, so a kernel keeps its size.
// Use it:     with a temporal or spatial filter after it. With frame always 0, the pattern is static.
#ifndef PENUMBRA_NOISE_HLSL
#define PENUMBRA_NOISE_HLSL

float GradientNoise(float2 pixel, uint frame)
{
    const float2 moved = pixel + 5.588238 * float(frame & 63u);
    return frac(52.9829189 * frac(dot(moved, float2(0.06711056, 0.00583715))));
}

// Chooses a pixel's cascade in a border. Rows and columns change places because another frame's noise would be that of
// the rotation, shifted by the same amount everywhere, and each cascade would have a part of the angles only.
float CascadeNoise(float2 pixel, uint frame)
{
    return GradientNoise(pixel.yx, frame);
}

float2 RotationFromNoise(float noise)
{
    const float angle = 6.2831853 * noise;
    return float2(cos(angle), sin(angle));
}

float2 DiskRotation(float2 pixel, uint frame)
{
    return RotationFromNoise(GradientNoise(pixel, frame));
}

#endif
