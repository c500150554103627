using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Screen/SampleEdges.technique.json; do not edit.
    /// <summary>Which samples of a pixel count as different surfaces.</summary>
    [System.Serializable]
    public struct EdgeParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraEdgeParameters0");

        /// <summary>Samples of a pixel: 2, 4 or 8.</summary>
        [Tooltip("Samples of a pixel: 2, 4 or 8."), Range(2, 8)] public int edgeSamples;
        /// <summary>Plane distance threshold, in pixel footprints: a sample farther from another's plane is on another surface. Unit: pixels.</summary>
        [Tooltip("Plane distance threshold, in pixel footprints: a sample farther from another's plane is on another surface. Unit: pixels."), Range(0.0f, 1e+06f)] public float depthTolerance;
        /// <summary>Cosine of the largest angle between the normals of samples on one surface.</summary>
        [Tooltip("Cosine of the largest angle between the normals of samples on one surface."), Range(-1.0f, 1.0f)] public float normalCosine;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static EdgeParameters Default => new EdgeParameters
            { edgeSamples = 4, depthTolerance = 1.0f, normalCosine = 0.9f };

        /// <summary>_PenumbraEdgeParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(edgeSamples, 2, 8),
            Bounded.OrLow(depthTolerance, 0.0f, 1e+06f), Bounded.OrLow(normalCosine, -1.0f, 1.0f), 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
