using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Filters/Peers/UnrealSmrt.technique.json; do not edit.
    /// <summary>SMRT (Unreal): shadow map ray tracing with the parameters of Unreal Engine.</summary>
    [System.Serializable]
    public struct UnrealSmrtParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraUnrealSmrtParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraUnrealSmrtParameters1");

        /// <summary>Rays to the light's disc, 1 to 64. Unit: rays.</summary>
        [Tooltip("Rays to the light's disc, 1 to 64. Unit: rays."), Range(1, 64)] public int rays;
        /// <summary>Samples of a ray beside that at the receiver, 1 to 64. Unit: fetches.</summary>
        [Tooltip("Samples of a ray beside that at the receiver, 1 to 64. Unit: fetches."), Range(1, 64)] public int samplesPerRay;
        /// <summary>Length of a ray, in halves of the tile's width.</summary>
        [Tooltip("Length of a ray, in halves of the tile's width."), Range(0.0f, 1000.0f)] public float rayLengthScale;
        /// <summary>Random offset of a ray, in half texels from side to side.</summary>
        [Tooltip("Random offset of a ray, in half texels from side to side."), Range(0.0f, 64.0f)] public float texelDither;
        /// <summary>Largest change of depth along a ray, with which a surface is continued behind a caster. Unit: m.</summary>
        [Tooltip("Largest change of depth along a ray, with which a surface is continued behind a caster. Unit: m."), Range(0.0f, 1e+06f)] public float largestSlopeMetres;
        /// <summary>Distance of the receiver from its surface, in thousandths of half the tile's width.</summary>
        [Tooltip("Distance of the receiver from its surface, in thousandths of half the tile's width."), Range(0.0f, 1000.0f)] public float normalBias;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static UnrealSmrtParameters Default => new UnrealSmrtParameters
            { rays = 7, samplesPerRay = 8, rayLengthScale = 1.5f, texelDither = 2.0f, largestSlopeMetres = 0.05f,
              normalBias = 0.5f };

        /// <summary>_PenumbraUnrealSmrtParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(rays, 1, 64), Bounded.Count(samplesPerRay, 1, 64),
            Bounded.OrLow(rayLengthScale, 0.0f, 1000.0f), Bounded.OrLow(texelDither, 0.0f, 64.0f));
        /// <summary>_PenumbraUnrealSmrtParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(largestSlopeMetres, 0.0f, 1e+06f),
            Bounded.OrLow(normalBias, 0.0f, 1000.0f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
        }
    }
}
