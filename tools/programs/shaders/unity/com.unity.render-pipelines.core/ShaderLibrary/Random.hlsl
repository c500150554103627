// Stands in for the core package's Random.hlsl: its noise is the library's (the same formula), by its name.
#ifndef STANDS_IN_FOR_RANDOM
#define STANDS_IN_FOR_RANDOM

#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/Noise.hlsl"

float InterleavedGradientNoise(float2 pixel, int frame)
{
    return GradientNoise(pixel, uint(frame));
}

#endif
