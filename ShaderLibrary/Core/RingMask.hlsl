// Penumbra: which rings of a disc are blocked, one bit each.
//
// Computes:   where the tap of a ring lies, how many rings lie inside of a circle, and the lit share of that circle.
// Source:     a disc of radius 1 in N rings, ring k from radius (k / N)^(e/2) to ((k + 1) / N)^(e/2). Up to ring n its
//             area is (n / N)^e: with e = 1 rings have equal areas, and their middles are Vogel's (1979); with e = 2
//             they have equal widths, and areas of 1, 3, 5, ... The bits of the blocked rings then give their area by
//             counts:
//
//                 | 0 |1|2|3:       bits 0 to 2 lie inside of the circle, bit 3 by its share before the circle
//
//             e = 1: the count of bits. e = 2: the sum of 2 k + 1, where the sum of k comes from the counts of the bits
//             whose index has 1, 2, 4, 8 or 16 in it.
// Inputs:     ratio: circle's radius to the disc's; rings: 1 to the number of taps; exponent: e, 1 or 2.
// Cost:       no fetches; for 32 taps 2 countbits, with e = 2 12.
// Guarantees: in [0, 1]; exactly 1 where no bit inside of the circle is set, exactly 0 where all are.
// Use it:     with up to 32 taps. PENUMBRA_UNLIMITED: up to 1024, for reference results.
#ifndef PENUMBRA_RING_MASK_HLSL
#define PENUMBRA_RING_MASK_HLSL

#include "../Platform/Platform.hlsl"
#include "Penumbra.hlsl"

#if defined(PENUMBRA_UNLIMITED)
static const int kRingWords = 32;
#else
static const int kRingWords = 1;
#endif

struct RingMask
{
    uint words[kRingWords];
};

int BoundedRingCount(int count)
{
    return min(max(count, 1), 32 * kRingWords);
}

int BoundedRingExponent(int exponent)
{
    return min(max(exponent, 1), 2);
}

RingMask EmptyRingMask()
{
    RingMask mask;
    UNITY_UNROLL
    for (int i = 0; i < kRingWords; ++i) mask.words[i] = 0u;
    return mask;
}

uint RingBit(int ring)
{
    return 1u << uint(ring & 31);
}

// Bits of the innermost rings, 0 to 32 of them. A shift by 32 is undefined.
uint InnermostRings(int count)
{
    return count >= 32 ? 0xFFFFFFFFu : RingBit(max(count, 0)) - 1u;
}

// Radius of the tap of ring `ring`, in a disc of radius 1.
float RingTapRadius(int ring, int count, int exponent)
{
    const float middle = (float(ring) + 0.5) / float(count);
    return exponent == 1 ? sqrt(middle) : middle;
}

// Number of the disc's rings that lie inside of a circle; at least 1, for the innermost.
float RingsInside(float ratio, int count, int exponent)
{
    const float inside = min(max(ratio, 0.0), 1.0);
    return min(max(float(count) * (exponent == 1 ? inside * inside : inside), 1.0), float(count));
}

// Area of the rings whose bits are set in a word, in units of the innermost ring's area. `first` is the word's first
// ring.
uint AreaOfBits(uint bits, int first, int exponent)
{
    const uint count = countbits(bits);
    if (exponent == 1) return count;
    const uint indices = countbits(bits & 0xAAAAAAAAu) + 2u * countbits(bits & 0xCCCCCCCCu) +
                         4u * countbits(bits & 0xF0F0F0F0u) + 8u * countbits(bits & 0xFF00FF00u) +
                         16u * countbits(bits & 0xFFFF0000u);
    return 2u * indices + (2u * uint(first) + 1u) * count;
}

float RingVisibility(RingMask mask, float rings, int exponent)
{
    const int whole = int(rings);
    uint lit = 0u;
    uint blocked = 0u;
    UNITY_UNROLL
    for (int i = 0; i < kRingWords; ++i)
    {
        const uint inside = InnermostRings(whole - 32 * i);
        lit += AreaOfBits(inside & ~mask.words[i], 32 * i, exponent);
        blocked += AreaOfBits(inside & mask.words[i], 32 * i, exponent);
    }
    const float part = rings - float(whole);
    // The area of ring `whole`'s part is rings^e - whole^e.
    const float share = exponent == 1 ? part : part * (rings + float(whole));
    const bool last = (mask.words[min(whole >> 5, kRingWords - 1)] & RingBit(whole)) != 0u;
    return LitShare(float(lit) + (last ? 0.0 : share), float(blocked) + (last ? share : 0.0));
}

#endif
