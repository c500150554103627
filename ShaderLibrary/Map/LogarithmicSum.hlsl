// Penumbra: means of exponentials, kept as logarithms.
//
// Computes:   log(sum of w_i exp(x_i)) from one x after the other, without overflow for any x.
// Source:     Salvi, "Rendering Filtered Shadows with Exponential Shadow Maps", ShaderX 6, 2008 (filtering in log
//             space). Here each term is relative to the largest so far.
// Inputs:     terms x, finite; weights w > 0.
// Cost:       no fetches; two exponentials per term, one logarithm per sum.
// Guarantees: no term exceeds 1 before it is weighted; the sum is at least the largest term's weight.
// Use it:     for maps of exponential means, whose own values would overflow. Not: for values of both signs.
#ifndef PENUMBRA_LOGARITHMIC_SUM_HLSL
#define PENUMBRA_LOGARITHMIC_SUM_HLSL

struct LogarithmicSum
{
    float largest;
    float sum; // relative to exp(largest)
};

LogarithmicSum EmptyLogarithmicSum()
{
    LogarithmicSum sum;
    sum.largest = -1e30;
    sum.sum = 0.0;
    return sum;
}

LogarithmicSum AddTerm(LogarithmicSum before, float x, float weight)
{
    LogarithmicSum after;
    after.largest = max(before.largest, x);
    after.sum = before.sum * exp(before.largest - after.largest) + weight * exp(x - after.largest);
    return after;
}

float LogarithmOf(LogarithmicSum sum)
{
    return sum.largest + log(sum.sum);
}

#endif
