// Shadows of what the camera sees, by a march over its depth texture.
// Written by `penumbra emit` from ShaderLibrary/Screen/ScreenTrace.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_SCREEN_TRACE_PARAMETERS_HLSL
#define PENUMBRA_SCREEN_TRACE_PARAMETERS_HLSL

struct ScreenTraceParameters
{
    // metres: length of the ray towards the sun; 0: no shadow, unless traceHeightShare is above 0
    float traceLengthMetres;
    // 1: the ray is at least this share of the picture's height at the receiver's distance: of a length that grows with
    // the view depth
    float traceHeightShare;
    // 1: samples along the ray, 1 to 64; fewer where the ray has fewer pixels
    int traceSteps;
    // metres: how far behind the surface that the camera sees geometry is taken to reach
    float traceThicknessMetres;
    // 1: is added to the thickness, as a share of the picture's height at the receiver's distance
    float traceThicknessShare;
    // 1: share of the ray, at its end, over which the shadow fades out
    float traceEndFade;
    // 1: share of the screen, at each border, over which the shadow of what is seen there fades out
    float traceBorderFade;
    // 1: cosine between the surface's normal and the sun below which the shadow fades out, up to a right angle
    float traceGrazing;
    // pixels: length of the ray in pixel footprints below which the shadow fades out with distance, up to half of it
    float traceFadePixels;
    // 1: share of a step by which noise moves a pixel's samples: 0 gives bands, 1 grain
    float traceJitter;
};

// Unpacks the uniforms _PenumbraScreenTraceParameters0, _PenumbraScreenTraceParameters1,
// _PenumbraScreenTraceParameters2, which the package's C# struct of the same name sets.
ScreenTraceParameters UnpackScreenTraceParameters(float4 packed0, float4 packed1, float4 packed2)
{
    ScreenTraceParameters parameters;
    parameters.traceLengthMetres = packed0.x;
    parameters.traceHeightShare = packed0.y;
    parameters.traceSteps = int(packed0.z);
    parameters.traceThicknessMetres = packed0.w;
    parameters.traceThicknessShare = packed1.x;
    parameters.traceEndFade = packed1.y;
    parameters.traceBorderFade = packed1.z;
    parameters.traceGrazing = packed1.w;
    parameters.traceFadePixels = packed2.x;
    parameters.traceJitter = packed2.y;
    return parameters;
}

#endif
