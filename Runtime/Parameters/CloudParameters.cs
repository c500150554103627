using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Far/CloudShadow.technique.json; do not edit.
    /// <summary>A procedural layer of clouds, and the map that holds its shadow.</summary>
    [System.Serializable]
    public struct CloudParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraCloudParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraCloudParameters1");

        /// <summary>Height of the layer, world space. Unit: m.</summary>
        [Tooltip("Height of the layer, world space. Unit: m."), Range(-10000.0f, 1e+05f)] public float cloudAltitudeMetres;
        /// <summary>Side of the map, which lies where the sun shines through the layer on the camera. Unit: m.</summary>
        [Tooltip("Side of the map, which lies where the sun shines through the layer on the camera. Unit: m."), Range(10.0f, 1e+06f)] public float cloudMapMetres;
        /// <summary>Share of the map over which the clouds' shadow fades out, on each side.</summary>
        [Tooltip("Share of the map over which the clouds' shadow fades out, on each side."), Range(0.0f, 0.5f)] public float cloudBorder;
        /// <summary>Size of the largest octave of the noise: larger values make larger clouds. Unit: m.</summary>
        [Tooltip("Size of the largest octave of the noise: larger values make larger clouds. Unit: m."), Range(1.0f, 1e+06f)] public float cloudFeatureMetres;
        /// <summary>0: no clouds, 1: everywhere.</summary>
        [Tooltip("0: no clouds, 1: everywhere."), Range(0.0f, 1.0f)] public float cloudCoverage;
        /// <summary>Optical depth straight up where the noise is highest: exp(-density) of the light passes there.</summary>
        [Tooltip("Optical depth straight up where the noise is highest: exp(-density) of the light passes there."), Range(0.0f, 100.0f)] public float cloudDensity;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static CloudParameters Default => new CloudParameters
            { cloudAltitudeMetres = 1600.0f, cloudMapMetres = 16000.0f, cloudBorder = 0.1f,
              cloudFeatureMetres = 2400.0f, cloudCoverage = 0.45f, cloudDensity = 4.0f };

        /// <summary>_PenumbraCloudParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(cloudAltitudeMetres, -10000.0f, 1e+05f),
            Bounded.OrLow(cloudMapMetres, 10.0f, 1e+06f), Bounded.OrLow(cloudBorder, 0.0f, 0.5f),
            Bounded.OrLow(cloudFeatureMetres, 1.0f, 1e+06f));
        /// <summary>_PenumbraCloudParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(cloudCoverage, 0.0f, 1.0f),
            Bounded.OrLow(cloudDensity, 0.0f, 100.0f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
