using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Peers/GodotPcss.technique.json; do not edit.
    /// <summary>PCSS (Godot): with the rules and parameters of Godot 4.</summary>
    [System.Serializable]
    public struct GodotPcssParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraGodotPcssParameters0");

        /// <summary>Number of blocker samples and of filter samples, 1 to 64: 4, 8, 12, 24 or 32 by quality. Unit: fetches.</summary>
        [Tooltip("Number of blocker samples and of filter samples, 1 to 64: 4, 8, 12, 24 or 32 by quality. Unit: fetches."), Range(1, 64)] public int samples;
        /// <summary>Angular size of the light, as a share of its diameter.</summary>
        [Tooltip("Angular size of the light, as a share of its diameter."), Range(0.0f, 4.0f)] public float diameterShare;
        /// <summary>By which the receiver moves toward the light, as a share of the depth range.</summary>
        [Tooltip("By which the receiver moves toward the light, as a share of the depth range."), Range(0.0f, 1.0f)] public float depthBias;
        /// <summary>By which the receiver moves along its normal, across the light alone. Unit: texels.</summary>
        [Tooltip("By which the receiver moves along its normal, across the light alone. Unit: texels."), Range(0.0f, 64.0f)] public float normalBias;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static GodotPcssParameters Default => new GodotPcssParameters
            { samples = 8, diameterShare = 1.0f, depthBias = 0.001f, normalBias = 2.0f };

        /// <summary>_PenumbraGodotPcssParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(samples, 1, 64),
            Bounded.OrLow(diameterShare, 0.0f, 4.0f), Bounded.OrLow(depthBias, 0.0f, 1.0f),
            Bounded.OrLow(normalBias, 0.0f, 64.0f));

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
