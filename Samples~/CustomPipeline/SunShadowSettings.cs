using System;
using UnityEngine;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>The sun's shadow settings in user units: metres, degrees, texels.</summary>
    [Serializable]
    public sealed class SunShadowSettings
    {
        [Tooltip("Width of the shadow map in texels.")]
        [Range(256, 8192)] public int resolution = 2048;

        [Tooltip("Number of cascades, 1 to 4.")]
        [Range(1, AtlasLayout.MostCascades)] public int cascades = 4;

        [Tooltip("Distance from the camera up to which there are shadows, in metres.")]
        public float distanceMetres = 100.0f;

        [Tooltip("Where the first three cascades end, as fractions of the distance.")]
        public Vector3 splits = new Vector3(0.067f, 0.2f, 0.467f);

        [Tooltip("Full angle of the sun's disc in degrees: 0.53 for the real sun, several for a hazy sky.")]
        [Range(AngularDiameter.SmallestDegrees, AngularDiameter.LargestDegrees)]
        public float angularDiameterDegrees = AngularDiameter.SunDegrees;

        [Tooltip("Texture fetches per pixel that search for shadow casters, 1 to 64.")]
        [Range(1, 64)] public int blockerSamples = 24;

        [Tooltip("Texture fetches per pixel that measure how much of the sun is visible, 1 to 64.")]
        [Range(1, 64)] public int filterSamples = 16;

        [Tooltip("Moves casters away from the sun, in texels of a tile.")]
        [Range(0.0f, 10.0f)] public float depthBias = 1.0f;

        [Tooltip("Shrinks casters along their normals, in texels of a tile. PCSS compares with the receiver's plane " +
                 "and needs no such bias.")]
        [Range(0.0f, 10.0f)] public float normalBias;

        [Tooltip("Ambient light, equal from all directions, linear.")]
        [Range(0.0f, 1.0f)] public float ambient = 0.15f;

        internal AtlasLayout Layout => new AtlasLayout(resolution, cascades);

        internal SoftShadowParameters Parameters
        {
            get
            {
                SoftShadowParameters parameters = SoftShadowParameters.Default;
                parameters.AngularDiameterDegrees = angularDiameterDegrees;
                parameters.BlockerSamples = blockerSamples;
                parameters.FilterSamples = filterSamples;
                return parameters;
            }
        }
    }
}
