using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraBlobs.technique.json; do not edit.
    /// <summary>Shadows of balls that stand for objects.</summary>
    [System.Serializable]
    public struct BlobParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraBlobParameters0");

        /// <summary>Height of a ball's lowest point over the receiver at which its shadow has faded; 0: no shadow fades. Unit: m.</summary>
        [Tooltip("Height of a ball's lowest point over the receiver at which its shadow has faded; 0: no shadow fades. Unit: m."), Range(0.0f, 1000.0f)] public float blobFadeMetres;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static BlobParameters Default => new BlobParameters
            { blobFadeMetres = 0.0f };

        /// <summary>_PenumbraBlobParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(blobFadeMetres, 0.0f, 1000.0f), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
