using System;
using UnityEngine;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>The sun's shadow as a person sets it: metres, degrees, texels.</summary>
    [Serializable]
    public sealed class SunShadowSettings
    {
        [Tooltip("Width of the shadow map in texels.")]
        [Range(256, 8192)] public int resolution = 2048;

        [Tooltip("Number of cascades, 1 to 4.")]
        [Range(1, AtlasLayout.MostCascades)] public int cascades = 4;

        [Tooltip("How far from the camera there are shadows, metres.")]
        public float distanceMetres = 100.0f;

        [Tooltip("Where the first three cascades end, as shares of the distance.")]
        public Vector3 splits = new Vector3(0.067f, 0.2f, 0.467f);

        [Tooltip("Full angle of the sun's disc in degrees: the real one's is 0.53, a hazy sky is like several.")]
        [Range(AngularDiameter.SmallestDegrees, AngularDiameter.LargestDegrees)]
        public float angularDiameterDegrees = AngularDiameter.SunDegrees;

        [Tooltip("Texture fetches per pixel that look for what casts the shadow, 1 to 64.")]
        [Range(1, 64)] public int blockerSamples = 24;

        [Tooltip("Texture fetches per pixel that measure how much of the sun is seen, 1 to 64.")]
        [Range(1, 64)] public int filterSamples = 16;

        [Tooltip("Moves casters away from the sun, in texels of a tile.")]
        [Range(0.0f, 10.0f)] public float depthBias = 1.0f;

        [Tooltip("Shrinks casters along their normals, in texels of a tile. PCSS tests against the receiver's plane, " +
                 "and needs none.")]
        [Range(0.0f, 10.0f)] public float normalBias;

        [Tooltip("Light from everywhere, linear.")]
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
