// Penumbra: powers of two and binary logarithms, exact on every device.
//
// Computes:   2 to an integer power, and the smallest integer power that reaches a value.
// Source:     IEEE 754-2019, binary32: the exponent field. exp2 and log2 need not be exact: Vulkan ("Precision of
//             GLSL.std.450 Instructions") lets exp2 be off by 3 + 2|x| ULP and log2 by 2^-21 near 1, so that exp2(0)
//             may be less than 1, and the level of a width of 1 may be 1.
// Inputs:     exponents of -126 to 127; finite values of at least 1.
// Cost:       no fetches; two or three integer instructions.
// Guarantees: no rounding.
// Use it:     for the levels of textures and the widths of their texels. Not: for levels between two.
#ifndef PENUMBRA_POWERS_OF_TWO_HLSL
#define PENUMBRA_POWERS_OF_TWO_HLSL

float PowerOfTwo(int exponent)
{
    return asfloat(uint(exponent + 127) << 23u);
}

// The smallest exponent of which the power is not less than the value.
int CeilLog2(float value)
{
    return int((asuint(value) + 0x7FFFFFu) >> 23u) - 127;
}

#endif
