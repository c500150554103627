// PCSS and DPCF (Filament): with the rules and parameters of Filament.
// Written by `penumbra emit` from ShaderLibrary/Filters/Peers/FilamentPcss.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_FILAMENT_PARAMETERS_HLSL
#define PENUMBRA_FILAMENT_PARAMETERS_HLSL

struct FilamentParameters
{
    // fetches: samples of the blocker search, 1 to 16
    int blockerSamples;
    // fetches: samples of the filter of PCSS, 1 to 16
    int filterSamples;
    // m: radius of the bulb at the near plane, to which discShare adds
    float bulbRadiusMetres;
    // 1: radius of the bulb, as a share of that of the light's disc at the distance of the whole depth range
    float discShare;
    // half texels: by which the receiver moves along its normal, times the sine of its angle to the light
    float normalBias;
    // texels: by whose change of depth on its plane the receiver moves toward the light; 0 where casters are drawn with
    // a slope-scaled bias
    float slopeBias;
};

// Unpacks the uniforms _PenumbraFilamentParameters0, _PenumbraFilamentParameters1, which the package's C# struct of the
// same name sets.
FilamentParameters UnpackFilamentParameters(float4 packed0, float4 packed1)
{
    FilamentParameters parameters;
    parameters.blockerSamples = int(packed0.x);
    parameters.filterSamples = int(packed0.y);
    parameters.bulbRadiusMetres = packed0.z;
    parameters.discShare = packed0.w;
    parameters.normalBias = packed1.x;
    parameters.slopeBias = packed1.y;
    return parameters;
}

#endif
