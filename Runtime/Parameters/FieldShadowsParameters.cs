using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Fields/FieldShadows.technique.json; do not edit.
    /// <summary>Shadows of objects from their distance fields.</summary>
    [System.Serializable]
    public struct FieldShadowsParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraFieldShadowsParameters0");

        /// <summary>Steps along each ray or cone through an object's box, 1 to 256. Unit: fetches.</summary>
        [Tooltip("Steps along each ray or cone through an object's box, 1 to 256. Unit: fetches."), Range(1, 256)] public int fieldSteps;
        /// <summary>Objects farther from the receiver than this cast nothing. Unit: m.</summary>
        [Tooltip("Objects farther from the receiver than this cast nothing. Unit: m."), Range(0.01f, 10000.0f)] public float fieldFarthestMetres;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static FieldShadowsParameters Default => new FieldShadowsParameters
            { fieldSteps = 64, fieldFarthestMetres = 100.0f };

        /// <summary>_PenumbraFieldShadowsParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(fieldSteps, 1, 256),
            Bounded.OrLow(fieldFarthestMetres, 0.01f, 10000.0f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
