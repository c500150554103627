// Parameter structs of the techniques, one per family of filters.
// Written by `penumbra validate --emit-parameters` from the techniques' manifests; do not edit.
//
// Each comment gives the field's unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_TECHNIQUE_PARAMETERS_HLSL
#define PENUMBRA_TECHNIQUE_PARAMETERS_HLSL

// Kernel of N x N bilinear comparisons with equal weights.
struct BoxParameters
{
    int tapsPerSide; // taps: N, odd, 1 to 9
};

// PCSS (Poisson): as many blocker samples as filter samples, on Poisson disks.
struct PcssClassicParameters
{
    int samples; // fetches: number of blocker samples and of filter samples: 25, 32, 64, 100 or 128
    float searchRadiusMetres; // m: radius of the blocker search, across the light
    float minFilterTexels; // texels: smallest filter radius
};

// PCSS: penumbra widths follow from the light's angular diameter.
struct PcssAngularParameters
{
    int blockerSamples; // fetches: samples of the blocker search, 1 to 64
    int filterSamples; // fetches: samples of the filter, 1 to 64
    float blockerClump; // 1: radial distribution of the search samples: 0 equally many per octave of radius, 1 uniform over the area, 2 density 1/r
    float minFilterTexels; // texels: smallest filter and search radius
    float maxPenumbraMetres; // m: largest penumbra width, from visibility 0 to 1; caps both radii
    float maxSamplingMetres; // m: height of the light's cone above the receiver, beyond which it is a cylinder
};

// PCSS (HDRP): with the rules and parameters of Unity's HDRP.
struct PcssHdrpParameters
{
    int blockerSamples; // fetches: samples of the blocker search, 1 to 64
    int filterSamples; // fetches: samples of the filter, 1 to 64
    float blockerClump; // 1: radial distribution of the search samples: 1 uniform over the area, 2 density 1/r, 4 density r^-1.5
    float minFilterTexels; // texels: smallest filter and search radius
    float maxPenumbraMetres; // m: caps the distance of blockers at this / (2 tan(a/2)) for a light of angular diameter a
    float maxSamplingMetres; // m: largest depth offset of the cone
    float searchTanHalf; // 1: tangent of half the blocker search's angular diameter
    float minFilterTanHalf; // 1: tangent of half the angular diameter of the cone below the smallest filter radius
};

// How far the penumbra mask extends beyond the edges that it found.
struct MaskParameters
{
    float maskPenumbraMetres; // m: largest penumbra width, from visibility 0 to 1, that the mask must cover; 0 for fixed filters
    float maskFilterTexels; // texels: smallest filter radius that the mask must cover, in texels of the shadow map
    int maskLargestRadius; // texels: largest radius of the dilation, in texels of the mask
};

// Smoothing of visibility in penumbrae.
struct DenoiseParameters
{
    int denoiseRadius; // pixels: radius of the neighbourhood, 0 to 8
    float planeTolerance; // pixels: plane distance threshold, in pixel footprints: beyond it a neighbour lies on another surface
    float noiseAmplitude; // 1: bilateral range threshold: a larger difference of visibility is an edge and no noise
};

#endif
