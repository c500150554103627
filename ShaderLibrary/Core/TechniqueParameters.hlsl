// Parameter structs of the techniques, one per family of filters.
// Written by `penumbra validate --emit-parameters` from ShaderLibrary/techniques.json; do not edit.
//
// Units stand before each field's meaning. Cost: no fetch.
#ifndef PENUMBRA_TECHNIQUE_PARAMETERS_HLSL
#define PENUMBRA_TECHNIQUE_PARAMETERS_HLSL

// Even kernel of N x N bilinear comparisons.
struct BoxParameters
{
    int tapsPerSide; // taps: N, odd, 1 to 9
};

// PCSS (Poisson): one number of samples, Poisson disks.
struct PcssClassicParameters
{
    int samples; // fetches: blocker samples, and again filter samples: 25, 32, 64, 100 or 128
    float searchRadiusMetres; // m: radius of the blocker search, across the light
    float minFilterTexels; // texels: smallest filter radius
};

// PCSS: by the light's angular diameter, geometric widths.
struct PcssAngularParameters
{
    int blockerSamples; // fetches: samples of the blocker search, 1 to 64
    int filterSamples; // fetches: samples of the filter, 1 to 64
    float blockerClump; // 1: search spread: 0 as many samples in every octave of radius, 1 even over the area, 2 dense as 1/r at the centre
    float minFilterTexels; // texels: smallest filter and search radius
    float maxPenumbraMetres; // m: widest penumbra, from 0 to 1; caps both radii
    float maxSamplingMetres; // m: height of the light's cone above the receiver, beyond which it is a cylinder
};

// PCSS (HDRP): with the rules and parameters of Unity's HDRP.
struct PcssHdrpParameters
{
    int blockerSamples; // fetches: samples of the blocker search, 1 to 64
    int filterSamples; // fetches: samples of the filter, 1 to 64
    float blockerClump; // 1: spread of the search: 1 even over the area, 2 a density of 1/r, 4 of r^-1.5
    float minFilterTexels; // texels: smallest filter and search radius
    float maxPenumbraMetres; // m: caps the distance of blockers at this over 2 tan(a/2)
    float maxSamplingMetres; // m: cap of the cone's depth offset
    float searchTanHalf; // 1: tangent of half the blocker search's angular diameter
    float minFilterTanHalf; // 1: tangent of half the angular diameter of the cone below the smallest filter radius
};

// How far the penumbra mask reaches beyond the edges it found.
struct MaskParameters
{
    float maskPenumbraMetres; // m: widest penumbra, from 0 to 1, that is allowed for; 0 for fixed filters
    float maskFilterTexels; // texels: smallest filter radius that is allowed for, in the shadow map
    int maskLargestRadius; // texels: bound of the widening, of the mask
};

// How far visibility is smoothed.
struct DenoiseParameters
{
    int denoiseRadius; // pixels: of the neighbourhood, 0 to 8
    float planeTolerance; // pixels: widths of a pixel beside a surface at which another one begins
    float noiseAmplitude; // 1: difference of visibility that noise does not make: it is kept
};

#endif
