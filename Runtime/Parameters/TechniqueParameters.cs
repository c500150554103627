using System;
using UnityEngine;
using UnityEngine.Rendering;

// Written by `penumbra emit` from the manifests, *.technique.json; do not edit. Of each struct:
// Default: the manifest's defaults; a field without one is 0, or the low end of its range.
// VectorN: the uniform UniformN, each component clamped to its range; NaN gives the low end.
// SetGlobal: sets the uniforms for all later draws. It does not allocate.
namespace Penumbra
{
    /// <summary>Kernel of N x N bilinear comparisons with equal weights.</summary>
    [Serializable]
    public struct BoxParameters
    {
        [Tooltip("N, odd, 1 to 9. Unit: taps."), Range(1, 9)] public int tapsPerSide;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraBoxParameters0");
        public static BoxParameters Default => new BoxParameters
            { tapsPerSide = 1 };
        public Vector4 Vector0 => new Vector4(Bounded.Count(tapsPerSide, 1, 9), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>PCSS (Poisson): as many blocker samples as filter samples, on Poisson disks.</summary>
    [Serializable]
    public struct PcssClassicParameters
    {
        [Tooltip("Number of blocker samples and of filter samples: 25, 32, 64, 100 or 128. Unit: fetches."), Range(25, 128)] public int samples;
        [Tooltip("Radius of the blocker search, across the light. Unit: m."), Range(0.0f, 1e+06f)] public float searchRadiusMetres;
        [Tooltip("Smallest filter radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssClassicParameters0");
        public static PcssClassicParameters Default => new PcssClassicParameters
            { samples = 25, searchRadiusMetres = 0.5f, minFilterTexels = 1.25f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(samples, 25, 128),
            Bounded.OrLow(searchRadiusMetres, 0.0f, 1e+06f), Bounded.OrLow(minFilterTexels, 0.0f, 64.0f), 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>PCSS: penumbra widths follow from the light's angular diameter.</summary>
    [Serializable]
    public struct PcssAngularParameters
    {
        [Tooltip("Samples of the blocker search, 1 to 128. Unit: fetches."), Range(1, 128)] public int blockerSamples;
        [Tooltip("Samples of the filter, 1 to 128. Unit: fetches."), Range(1, 128)] public int filterSamples;
        [Tooltip("Radial distribution of the search samples: 0 equally many per octave of radius, 1 uniform over the area, 2 density 1/r."), Range(0.0f, 8.0f)] public float blockerClump;
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        [Tooltip("Height of the light's cone above the receiver, beyond which it is a cylinder. Unit: m."), Range(0.0f, 1e+06f)] public float maxSamplingMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssAngularParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraPcssAngularParameters1");
        public static PcssAngularParameters Default => new PcssAngularParameters
            { blockerSamples = 1, filterSamples = 1, blockerClump = 0.0f, minFilterTexels = 1.25f,
              maxPenumbraMetres = 100.0f, maxSamplingMetres = 1000.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 128),
            Bounded.Count(filterSamples, 1, 128), Bounded.OrLow(blockerClump, 0.0f, 8.0f),
            Bounded.OrLow(minFilterTexels, 0.0f, 64.0f));
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f),
            Bounded.OrLow(maxSamplingMetres, 0.0f, 1e+06f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>PCSS whose search ends where no blocker can be.</summary>
    [Serializable]
    public struct PcssBoundedParameters
    {
        [Tooltip("Samples of the blocker search, 1 to 128. Unit: fetches."), Range(1, 128)] public int searchSamples;
        [Tooltip("Samples of the filter in penumbrae wider than 4.25 texels, 1 to 128. Unit: fetches."), Range(1, 128)] public int filterSamples;
        [Tooltip("Largest penumbra width, from visibility 0 to 1. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssBoundedParameters0");
        public static PcssBoundedParameters Default => new PcssBoundedParameters
            { searchSamples = 1, filterSamples = 1, maxPenumbraMetres = 100.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(searchSamples, 1, 128),
            Bounded.Count(filterSamples, 1, 128), Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f), 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>PCSS (HDRP): with the rules and parameters of Unity's HDRP.</summary>
    [Serializable]
    public struct PcssHdrpParameters
    {
        [Tooltip("Samples of the blocker search, 1 to 64. Unit: fetches."), Range(1, 64)] public int blockerSamples;
        [Tooltip("Samples of the filter, 1 to 64. Unit: fetches."), Range(1, 64)] public int filterSamples;
        [Tooltip("Radial distribution of the search samples: 1 uniform over the area, 2 density 1/r, 4 density r^-1.5."), Range(1.0f, 8.0f)] public float blockerClump;
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        [Tooltip("Caps the distance of blockers at this / (2 tan(a/2)) for a light of angular diameter a. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        [Tooltip("Largest depth offset of the cone. Unit: m."), Range(0.0f, 1e+06f)] public float maxSamplingMetres;
        [Tooltip("Tangent of half the blocker search's angular diameter."), Range(0.0f, 1000.0f)] public float searchTanHalf;
        [Tooltip("Tangent of half the angular diameter of the cone below the smallest filter radius."), Range(0.0f, 1000.0f)] public float minFilterTanHalf;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssHdrpParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraPcssHdrpParameters1");
        public static PcssHdrpParameters Default => new PcssHdrpParameters
            { blockerSamples = 1, filterSamples = 1, blockerClump = 1.0f, minFilterTexels = 0.0f,
              maxPenumbraMetres = 0.0f, maxSamplingMetres = 0.0f, searchTanHalf = 0.0f, minFilterTanHalf = 0.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 64),
            Bounded.Count(filterSamples, 1, 64), Bounded.OrLow(blockerClump, 1.0f, 8.0f),
            Bounded.OrLow(minFilterTexels, 0.0f, 64.0f));
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f),
            Bounded.OrLow(maxSamplingMetres, 0.0f, 1e+06f), Bounded.OrLow(searchTanHalf, 0.0f, 1000.0f),
            Bounded.OrLow(minFilterTanHalf, 0.0f, 1000.0f));
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>Shadows beyond the cascades, and how the cascades are handed over to them.</summary>
    [Serializable]
    public struct FarShadowsParameters
    {
        [Tooltip("Share of the shadow distance, before its end, over which far shadows take over."), Range(0.0f, 1.0f)] public float handOverBorder;
        [Tooltip("Steps of a ray over the ground's heights, 1 to 256. Unit: fetches."), Range(1, 256)] public int heightSteps;
        [Tooltip("How far from the receiver that ray begins. Unit: m."), Range(0.01f, 10000.0f)] public float nearestMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFarShadowsParameters0");
        public static FarShadowsParameters Default => new FarShadowsParameters
            { handOverBorder = 0.2f, heightSteps = 64, nearestMetres = 20.0f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(handOverBorder, 0.0f, 1.0f),
            Bounded.Count(heightSteps, 1, 256), Bounded.OrLow(nearestMetres, 0.01f, 10000.0f), 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Shadows of objects from their distance fields.</summary>
    [Serializable]
    public struct FieldShadowsParameters
    {
        [Tooltip("Steps along each ray or cone through an object's box, 1 to 256. Unit: fetches."), Range(1, 256)] public int fieldSteps;
        [Tooltip("Objects farther from the receiver than this cast nothing. Unit: m."), Range(0.01f, 10000.0f)] public float fieldFarthestMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFieldShadowsParameters0");
        public static FieldShadowsParameters Default => new FieldShadowsParameters
            { fieldSteps = 64, fieldFarthestMetres = 100.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(fieldSteps, 1, 256),
            Bounded.OrLow(fieldFarthestMetres, 0.01f, 10000.0f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>A procedural layer of clouds, and the map that holds its shadow.</summary>
    [Serializable]
    public struct CloudParameters
    {
        [Tooltip("Height of the layer, world space. Unit: m."), Range(-10000.0f, 1e+05f)] public float cloudAltitudeMetres;
        [Tooltip("Side of the map, which lies where the sun shines through the layer on the camera. Unit: m."), Range(10.0f, 1e+06f)] public float cloudMapMetres;
        [Tooltip("Share of the map over which the clouds' shadow fades out, on each side."), Range(0.0f, 0.5f)] public float cloudBorder;
        [Tooltip("Size of the largest octave of the noise: larger values make larger clouds. Unit: m."), Range(1.0f, 1e+06f)] public float cloudFeatureMetres;
        [Tooltip("0: no clouds, 1: everywhere."), Range(0.0f, 1.0f)] public float cloudCoverage;
        [Tooltip("Optical depth straight up where the noise is highest: exp(-density) of the light passes there."), Range(0.0f, 100.0f)] public float cloudDensity;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraCloudParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraCloudParameters1");
        public static CloudParameters Default => new CloudParameters
            { cloudAltitudeMetres = 1600.0f, cloudMapMetres = 16000.0f, cloudBorder = 0.1f,
              cloudFeatureMetres = 2400.0f, cloudCoverage = 0.45f, cloudDensity = 4.0f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(cloudAltitudeMetres, -10000.0f, 1e+05f),
            Bounded.OrLow(cloudMapMetres, 10.0f, 1e+06f), Bounded.OrLow(cloudBorder, 0.0f, 0.5f),
            Bounded.OrLow(cloudFeatureMetres, 1.0f, 1e+06f));
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(cloudCoverage, 0.0f, 1.0f),
            Bounded.OrLow(cloudDensity, 0.0f, 100.0f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>Blur of a filtered shadow map.</summary>
    [Serializable]
    public struct MapBlurParameters
    {
        [Tooltip("Standard deviation of the Gaussian. Unit: texels."), Range(0.0f, 4.0f)] public float deviation;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMapBlurParameters0");
        public static MapBlurParameters Default => new MapBlurParameters
            { deviation = 1.5f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(deviation, 0.0f, 4.0f), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Variance shadow maps.</summary>
    [Serializable]
    public struct VarianceParameters
    {
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        [Tooltip("Unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16."), Range(5.9604645e-08f, 0.01f)] public float precision;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraVarianceParameters0");
        public static VarianceParameters Default => new VarianceParameters
            { bleeding = 0.2f, precision = 5.9604645e-08f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(precision, 5.9604645e-08f, 0.01f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>How far the penumbra mask extends beyond the edges that it found.</summary>
    [Serializable]
    public struct MaskParameters
    {
        [Tooltip("Largest penumbra width, from visibility 0 to 1, that the mask must cover; 0 for fixed filters. Unit: m."), Range(0.0f, 1e+06f)] public float maskPenumbraMetres;
        [Tooltip("Smallest filter radius that the mask must cover, in texels of the shadow map. Unit: texels."), Range(0.0f, 64.0f)] public float maskFilterTexels;
        [Tooltip("Largest radius of the dilation, in texels of the mask. Unit: texels."), Range(0, 1024)] public int maskLargestRadius;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMaskParameters0");
        public static MaskParameters Default => new MaskParameters
            { maskPenumbraMetres = 100.0f, maskFilterTexels = 2.0f, maskLargestRadius = 32 };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(maskPenumbraMetres, 0.0f, 1e+06f),
            Bounded.OrLow(maskFilterTexels, 0.0f, 64.0f), Bounded.Count(maskLargestRadius, 0, 1024), 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Samples of a multisampled shadow map.</summary>
    [Serializable]
    public struct MapSampleParameters
    {
        [Tooltip("Samples of a texel: 2, 4 or 8."), Range(2, 8)] public int mapSamples;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMapSampleParameters0");
        public static MapSampleParameters Default => new MapSampleParameters
            { mapSamples = 4 };
        public Vector4 Vector0 => new Vector4(Bounded.Count(mapSamples, 2, 8), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Exponential shadow maps.</summary>
    [Serializable]
    public struct ExponentialParameters
    {
        [Tooltip("C of exp(c z), for depths z over the range of the map: at most 172 with 32 bits, 19 with 16."), Range(1.0f, 172.0f)] public float exponent;
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraExponentialParameters0");
        public static ExponentialParameters Default => new ExponentialParameters
            { exponent = 172.0f, bleeding = 0.2f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(exponent, 1.0f, 172.0f),
            Bounded.OrLow(bleeding, 0.0f, 0.95f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Smoothing of visibility in penumbrae.</summary>
    [Serializable]
    public struct DenoiseParameters
    {
        [Tooltip("Radius of the neighbourhood, 0 to 8. Unit: pixels."), Range(0, 8)] public int denoiseRadius;
        [Tooltip("Plane distance threshold, in pixel footprints: a neighbour farther away counts as another surface. Unit: pixels."), Range(0.0f, 1e+06f)] public float planeTolerance;
        [Tooltip("Bilateral range threshold: a larger difference of visibility counts as an edge, not as noise."), Range(0.0f, 1.0f)] public float noiseAmplitude;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraDenoiseParameters0");
        public static DenoiseParameters Default => new DenoiseParameters
            { denoiseRadius = 2, planeTolerance = 2.0f, noiseAmplitude = 0.25f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(denoiseRadius, 0, 8),
            Bounded.OrLow(planeTolerance, 0.0f, 1e+06f), Bounded.OrLow(noiseAmplitude, 0.0f, 1.0f), 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Exponential shadow maps in logarithmic space.</summary>
    [Serializable]
    public struct LogExponentialParameters
    {
        [Tooltip("C of exp(c z), for depths z over the range of the map."), Range(1.0f, 1000.0f)] public float exponent;
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraLogExponentialParameters0");
        public static LogExponentialParameters Default => new LogExponentialParameters
            { exponent = 172.0f, bleeding = 0.2f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(exponent, 1.0f, 1000.0f),
            Bounded.OrLow(bleeding, 0.0f, 0.95f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Which samples of a pixel count as different surfaces.</summary>
    [Serializable]
    public struct EdgeParameters
    {
        [Tooltip("Samples of a pixel: 2, 4 or 8."), Range(2, 8)] public int edgeSamples;
        [Tooltip("Plane distance threshold, in pixel footprints: a sample farther from another's plane is on another surface. Unit: pixels."), Range(0.0f, 1e+06f)] public float depthTolerance;
        [Tooltip("Cosine of the largest angle between the normals of samples on one surface."), Range(-1.0f, 1.0f)] public float normalCosine;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraEdgeParameters0");
        public static EdgeParameters Default => new EdgeParameters
            { edgeSamples = 4, depthTolerance = 1.0f, normalCosine = 0.9f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(edgeSamples, 2, 8),
            Bounded.OrLow(depthTolerance, 0.0f, 1e+06f), Bounded.OrLow(normalCosine, -1.0f, 1.0f), 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Exponential variance shadow maps.</summary>
    [Serializable]
    public struct ExponentialVarianceParameters
    {
        [Tooltip("C of exp(c z), for depths z over the range of the map: at most 86 with 32 bits, 9 with 16."), Range(1.0f, 86.0f)] public float positiveExponent;
        [Tooltip("D of -exp(-d z), with the same limits."), Range(1.0f, 86.0f)] public float negativeExponent;
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        [Tooltip("Unit roundoff of the map's format: 2^-24 with 32 bits, 2^-11 with 16."), Range(5.9604645e-08f, 0.01f)] public float precision;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraExponentialVarianceParameters0");
        public static ExponentialVarianceParameters Default => new ExponentialVarianceParameters
            { positiveExponent = 80.0f, negativeExponent = 10.0f, bleeding = 0.2f, precision = 5.9604645e-08f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(positiveExponent, 1.0f, 86.0f),
            Bounded.OrLow(negativeExponent, 1.0f, 86.0f), Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(precision, 5.9604645e-08f, 0.01f));
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Shadows of what the camera sees, by a march over its depth texture.</summary>
    [Serializable]
    public struct ScreenTraceParameters
    {
        [Tooltip("Length of the ray towards the sun; 0: no shadow, unless traceHeightShare is above 0. Unit: metres."), Range(0.0f, 100.0f)] public float traceLengthMetres;
        [Tooltip("The ray is at least this share of the picture's height at the receiver's distance: of a length that grows with the view depth."), Range(0.0f, 1.0f)] public float traceHeightShare;
        [Tooltip("Samples along the ray, 1 to 64; fewer where the ray has fewer pixels."), Range(1, 64)] public int traceSteps;
        [Tooltip("How far behind the surface that the camera sees geometry is taken to reach. Unit: metres."), Range(0.0f, 100.0f)] public float traceThicknessMetres;
        [Tooltip("Is added to the thickness, as a share of the picture's height at the receiver's distance."), Range(0.0f, 1.0f)] public float traceThicknessShare;
        [Tooltip("Share of the ray, at its end, over which the shadow fades out."), Range(0.0f, 1.0f)] public float traceEndFade;
        [Tooltip("Share of the screen, at each border, over which the shadow of what is seen there fades out."), Range(0.0f, 0.5f)] public float traceBorderFade;
        [Tooltip("Cosine between the surface's normal and the sun below which the shadow fades out, up to a right angle."), Range(0.0f, 1.0f)] public float traceGrazing;
        [Tooltip("Length of the ray in pixel footprints below which the shadow fades out with distance, up to half of it. Unit: pixels."), Range(0.0f, 1000.0f)] public float traceFadePixels;
        [Tooltip("Share of a step by which noise moves a pixel's samples: 0 gives bands, 1 grain."), Range(0.0f, 1.0f)] public float traceJitter;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraScreenTraceParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraScreenTraceParameters1");
        public static readonly int Uniform2 = Shader.PropertyToID("_PenumbraScreenTraceParameters2");
        public static ScreenTraceParameters Default => new ScreenTraceParameters
            { traceLengthMetres = 0.5f, traceHeightShare = 0.0f, traceSteps = 12, traceThicknessMetres = 0.05f,
              traceThicknessShare = 0.0f, traceEndFade = 0.25f, traceBorderFade = 0.05f, traceGrazing = 0.05f,
              traceFadePixels = 2.0f, traceJitter = 1.0f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(traceLengthMetres, 0.0f, 100.0f),
            Bounded.OrLow(traceHeightShare, 0.0f, 1.0f), Bounded.Count(traceSteps, 1, 64),
            Bounded.OrLow(traceThicknessMetres, 0.0f, 100.0f));
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(traceThicknessShare, 0.0f, 1.0f),
            Bounded.OrLow(traceEndFade, 0.0f, 1.0f), Bounded.OrLow(traceBorderFade, 0.0f, 0.5f),
            Bounded.OrLow(traceGrazing, 0.0f, 1.0f));
        public Vector4 Vector2 => new Vector4(Bounded.OrLow(traceFadePixels, 0.0f, 1000.0f),
            Bounded.OrLow(traceJitter, 0.0f, 1.0f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
            commands.SetGlobalVector(Uniform2, Vector2);
        }
    }

    /// <summary>Moment shadow maps.</summary>
    [Serializable]
    public struct MomentShadowsParameters
    {
        [Tooltip("Share of a smooth distribution in the moments, against their rounding: 3e-7 with 32 bits, 6e-5 with 16."), Range(1e-07f, 0.1f)] public float mix;
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMomentShadowsParameters0");
        public static MomentShadowsParameters Default => new MomentShadowsParameters
            { mix = 3e-07f, bleeding = 0.2f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(mix, 1e-07f, 0.1f),
            Bounded.OrLow(bleeding, 0.0f, 0.95f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>SMRT (Unreal): shadow map ray tracing with the parameters of Unreal Engine.</summary>
    [Serializable]
    public struct UnrealSmrtParameters
    {
        [Tooltip("Rays to the light's disc, 1 to 64. Unit: rays."), Range(1, 64)] public int rays;
        [Tooltip("Samples of a ray beside that at the receiver, 1 to 64. Unit: fetches."), Range(1, 64)] public int samplesPerRay;
        [Tooltip("Length of a ray, in halves of the tile's width."), Range(0.0f, 1000.0f)] public float rayLengthScale;
        [Tooltip("Random offset of a ray, in half texels from side to side."), Range(0.0f, 64.0f)] public float texelDither;
        [Tooltip("Largest change of depth along a ray, with which a surface is continued behind a caster. Unit: m."), Range(0.0f, 1e+06f)] public float largestSlopeMetres;
        [Tooltip("Distance of the receiver from its surface, in thousandths of half the tile's width."), Range(0.0f, 1000.0f)] public float normalBias;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraUnrealSmrtParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraUnrealSmrtParameters1");
        public static UnrealSmrtParameters Default => new UnrealSmrtParameters
            { rays = 7, samplesPerRay = 8, rayLengthScale = 1.5f, texelDither = 2.0f, largestSlopeMetres = 0.05f,
              normalBias = 0.5f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(rays, 1, 64), Bounded.Count(samplesPerRay, 1, 64),
            Bounded.OrLow(rayLengthScale, 0.0f, 1000.0f), Bounded.OrLow(texelDither, 0.0f, 64.0f));
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(largestSlopeMetres, 0.0f, 1e+06f),
            Bounded.OrLow(normalBias, 0.0f, 1000.0f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>PCSS (Godot): with the rules and parameters of Godot 4.</summary>
    [Serializable]
    public struct GodotPcssParameters
    {
        [Tooltip("Number of blocker samples and of filter samples, 1 to 64: 4, 8, 12, 24 or 32 by quality. Unit: fetches."), Range(1, 64)] public int samples;
        [Tooltip("Angular size of the light, as a share of its diameter."), Range(0.0f, 4.0f)] public float diameterShare;
        [Tooltip("By which the receiver moves toward the light, as a share of the depth range."), Range(0.0f, 1.0f)] public float depthBias;
        [Tooltip("By which the receiver moves along its normal, across the light alone. Unit: texels."), Range(0.0f, 64.0f)] public float normalBias;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraGodotPcssParameters0");
        public static GodotPcssParameters Default => new GodotPcssParameters
            { samples = 8, diameterShare = 1.0f, depthBias = 0.001f, normalBias = 2.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(samples, 1, 64),
            Bounded.OrLow(diameterShare, 0.0f, 4.0f), Bounded.OrLow(depthBias, 0.0f, 1.0f),
            Bounded.OrLow(normalBias, 0.0f, 64.0f));
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>PCSS and DPCF (Filament): with the rules and parameters of Filament.</summary>
    [Serializable]
    public struct FilamentParameters
    {
        [Tooltip("Samples of the blocker search, 1 to 16. Unit: fetches."), Range(1, 16)] public int blockerSamples;
        [Tooltip("Samples of the filter of PCSS, 1 to 16. Unit: fetches."), Range(1, 16)] public int filterSamples;
        [Tooltip("Radius of the bulb at the near plane, to which discShare adds. Unit: m."), Range(0.0f, 1e+06f)] public float bulbRadiusMetres;
        [Tooltip("Radius of the bulb, as a share of that of the light's disc at the distance of the whole depth range."), Range(0.0f, 64.0f)] public float discShare;
        [Tooltip("By which the receiver moves along its normal, times the sine of its angle to the light. Unit: half texels."), Range(0.0f, 64.0f)] public float normalBias;
        [Tooltip("By whose change of depth on its plane the receiver moves toward the light; 0 where casters are drawn with a slope-scaled bias. Unit: texels."), Range(0.0f, 64.0f)] public float slopeBias;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFilamentParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraFilamentParameters1");
        public static FilamentParameters Default => new FilamentParameters
            { blockerSamples = 16, filterSamples = 16, bulbRadiusMetres = 0.0f, discShare = 0.5f,
              normalBias = 1.0f, slopeBias = 0.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 16),
            Bounded.Count(filterSamples, 1, 16), Bounded.OrLow(bulbRadiusMetres, 0.0f, 1e+06f),
            Bounded.OrLow(discShare, 0.0f, 64.0f));
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(normalBias, 0.0f, 64.0f),
            Bounded.OrLow(slopeBias, 0.0f, 64.0f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>Radii of the map of nearest and farthest depths around each texel.</summary>
    [Serializable]
    public struct DepthRangeParameters
    {
        [Tooltip("Radius in cascade 0, in texels of the quarter-resolution map: 8 are 32 texels of the shadow map. Unit: texels."), Range(0, 16)] public int dilation0;
        [Tooltip("The same in cascade 1. Unit: texels."), Range(0, 16)] public int dilation1;
        [Tooltip("The same in cascade 2. Unit: texels."), Range(0, 16)] public int dilation2;
        [Tooltip("The same in cascade 3. Unit: texels."), Range(0, 16)] public int dilation3;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraDepthRangeParameters0");
        public static DepthRangeParameters Default => new DepthRangeParameters
            { dilation0 = 8, dilation1 = 4, dilation2 = 3, dilation3 = 0 };
        public Vector4 Vector0 => new Vector4(Bounded.Count(dilation0, 0, 16), Bounded.Count(dilation1, 0, 16),
            Bounded.Count(dilation2, 0, 16), Bounded.Count(dilation3, 0, 16));
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Soft shadows of one loop over the rings of a disc.</summary>
    [Serializable]
    public struct SingleLoopParameters
    {
        [Tooltip("Taps, one on each ring of the disc, 1 to 32. Unit: fetches."), Range(1, 32)] public int samples;
        [Tooltip("Rings of the disc: 1 of equal area, 2 of equal width."), Range(1, 2)] public int ringExponent;
        [Tooltip("Largest radius of the disc, and with it of a penumbra, across the light. Unit: m."), Range(0.0f, 1e+06f)] public float discRadiusMetres;
        [Tooltip("Smallest radius of disc and penumbra. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        [Tooltip("Of the map of nearest and farthest depths that an early exit reads: its radius in cascade 0. Unit: texels."), Range(0, 16)] public int dilation0;
        [Tooltip("The same in cascade 1. Unit: texels."), Range(0, 16)] public int dilation1;
        [Tooltip("The same in cascade 2. Unit: texels."), Range(0, 16)] public int dilation2;
        [Tooltip("The same in cascade 3. Unit: texels."), Range(0, 16)] public int dilation3;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraSingleLoopParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraSingleLoopParameters1");
        public static SingleLoopParameters Default => new SingleLoopParameters
            { samples = 32, ringExponent = 1, discRadiusMetres = 0.05f, minFilterTexels = 1.25f, dilation0 = 8,
              dilation1 = 4, dilation2 = 3, dilation3 = 0 };
        public Vector4 Vector0 => new Vector4(Bounded.Count(samples, 1, 32), Bounded.Count(ringExponent, 1, 2),
            Bounded.OrLow(discRadiusMetres, 0.0f, 1e+06f), Bounded.OrLow(minFilterTexels, 0.0f, 64.0f));
        public Vector4 Vector1 => new Vector4(Bounded.Count(dilation0, 0, 16), Bounded.Count(dilation1, 0, 16),
            Bounded.Count(dilation2, 0, 16), Bounded.Count(dilation3, 0, 16));
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>Variance soft shadow mapping.</summary>
    [Serializable]
    public struct VssmParameters
    {
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.5f, 64.0f)] public float minFilterTexels;
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        [Tooltip("Variance that rounding may leave of a flat surface, of depths in [-1/2, 1/2]."), Range(1e-07f, 0.01f)] public float smallestVariance;
        [Tooltip("Searches for blockers, each within the penumbra that the one before found; the paper has one."), Range(1, 4)] public int searches;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraVssmParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraVssmParameters1");
        public static VssmParameters Default => new VssmParameters
            { minFilterTexels = 1.0f, maxPenumbraMetres = 100.0f, bleeding = 0.2f, smallestVariance = 1.2e-07f,
              searches = 3 };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(minFilterTexels, 0.5f, 64.0f),
            Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f), Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(smallestVariance, 1e-07f, 0.01f));
        public Vector4 Vector1 => new Vector4(Bounded.Count(searches, 1, 4), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>Moment soft shadow mapping.</summary>
    [Serializable]
    public struct MssmParameters
    {
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.5f, 64.0f)] public float minFilterTexels;
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        [Tooltip("Visibility up to which all is dark, which reduces light bleeding."), Range(0.0f, 0.95f)] public float bleeding;
        [Tooltip("Share of a smooth distribution in the moments, against their rounding."), Range(1e-07f, 0.1f)] public float mix;
        [Tooltip("Searches for blockers, each within the penumbra that the one before found; the paper has one."), Range(1, 4)] public int searches;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraMssmParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraMssmParameters1");
        public static MssmParameters Default => new MssmParameters
            { minFilterTexels = 1.0f, maxPenumbraMetres = 100.0f, bleeding = 0.2f, mix = 6e-05f, searches = 3 };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(minFilterTexels, 0.5f, 64.0f),
            Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f), Bounded.OrLow(bleeding, 0.0f, 0.95f),
            Bounded.OrLow(mix, 1e-07f, 0.1f));
        public Vector4 Vector1 => new Vector4(Bounded.Count(searches, 1, 4), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }

    /// <summary>PCSS of a spot light: penumbra widths follow from the radius of its source.</summary>
    [Serializable]
    public struct PcssSpotParameters
    {
        [Tooltip("Samples of the blocker search, 1 to 64. Unit: fetches."), Range(1, 64)] public int blockerSamples;
        [Tooltip("Samples of the filter, 1 to 64. Unit: fetches."), Range(1, 64)] public int filterSamples;
        [Tooltip("Smallest filter and search radius. Unit: texels."), Range(0.0f, 64.0f)] public float minFilterTexels;
        [Tooltip("Largest penumbra width, from visibility 0 to 1; caps both radii. Unit: m."), Range(0.0f, 1e+06f)] public float maxPenumbraMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPcssSpotParameters0");
        public static PcssSpotParameters Default => new PcssSpotParameters
            { blockerSamples = 1, filterSamples = 1, minFilterTexels = 1.25f, maxPenumbraMetres = 100.0f };
        public Vector4 Vector0 => new Vector4(Bounded.Count(blockerSamples, 1, 64),
            Bounded.Count(filterSamples, 1, 64), Bounded.OrLow(minFilterTexels, 0.0f, 64.0f),
            Bounded.OrLow(maxPenumbraMetres, 0.0f, 1e+06f));
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Shadows flattened onto a plane.</summary>
    [Serializable]
    public struct PlanarParameters
    {
        [Tooltip("Height over the plane of what casts no shadow any more; 0: no shadow fades. Unit: m."), Range(0.0f, 1000.0f)] public float planarFadeMetres;
        [Tooltip("How far from the plane a surface may lie that receives its shadows. Unit: m."), Range(0.0f, 10.0f)] public float planarToleranceMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraPlanarParameters0");
        public static PlanarParameters Default => new PlanarParameters
            { planarFadeMetres = 0.0f, planarToleranceMetres = 0.002f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(planarFadeMetres, 0.0f, 1000.0f),
            Bounded.OrLow(planarToleranceMetres, 0.0f, 10.0f), 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }

    /// <summary>Shadows of balls that stand for objects.</summary>
    [Serializable]
    public struct BlobParameters
    {
        [Tooltip("Height of a ball's lowest point over the receiver at which its shadow has faded; 0: no shadow fades. Unit: m."), Range(0.0f, 1000.0f)] public float blobFadeMetres;
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraBlobParameters0");
        public static BlobParameters Default => new BlobParameters
            { blobFadeMetres = 0.0f };
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(blobFadeMetres, 0.0f, 1000.0f), 0.0f, 0.0f, 0.0f);
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
