using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Far/FarShadows.technique.json; do not edit.
    /// <summary>Shadows beyond the cascades, and how the cascades are handed over to them.</summary>
    [System.Serializable]
    public struct FarShadowsParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFarShadowsParameters0");

        /// <summary>Share of the shadow distance, before its end, over which far shadows take over.</summary>
        [Tooltip("Share of the shadow distance, before its end, over which far shadows take over."), Range(0.0f, 1.0f)] public float handOverBorder;
        /// <summary>Steps of a ray over the ground's heights, 1 to 256. Unit: fetches.</summary>
        [Tooltip("Steps of a ray over the ground's heights, 1 to 256. Unit: fetches."), Range(1, 256)] public int heightSteps;
        /// <summary>How far from the receiver that ray begins. Unit: m.</summary>
        [Tooltip("How far from the receiver that ray begins. Unit: m."), Range(0.01f, 10000.0f)] public float nearestMetres;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static FarShadowsParameters Default => new FarShadowsParameters
            { handOverBorder = 0.2f, heightSteps = 64, nearestMetres = 20.0f };

        /// <summary>_PenumbraFarShadowsParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(handOverBorder, 0.0f, 1.0f),
            Bounded.Count(heightSteps, 1, 256), Bounded.OrLow(nearestMetres, 0.01f, 10000.0f), 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
