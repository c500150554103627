using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from ShaderLibrary/Screen/ScreenTrace.technique.json; do not edit.
    /// <summary>Shadows of what the camera sees, by a march over its depth texture.</summary>
    [System.Serializable]
    public struct ScreenTraceParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraScreenTraceParameters0");
        public static readonly int Uniform1 = Shader.PropertyToID("_PenumbraScreenTraceParameters1");
        public static readonly int Uniform2 = Shader.PropertyToID("_PenumbraScreenTraceParameters2");

        /// <summary>Length of the ray towards the sun; 0: no shadow, unless traceHeightShare is above 0. Unit: metres.</summary>
        [Tooltip("Length of the ray towards the sun; 0: no shadow, unless traceHeightShare is above 0. Unit: metres."), Range(0.0f, 100.0f)] public float traceLengthMetres;
        /// <summary>The ray is at least this share of the picture's height at the receiver's distance: of a length that grows with the view depth.</summary>
        [Tooltip("The ray is at least this share of the picture's height at the receiver's distance: of a length that grows with the view depth."), Range(0.0f, 1.0f)] public float traceHeightShare;
        /// <summary>Samples along the ray, 1 to 64; fewer where the ray has fewer pixels.</summary>
        [Tooltip("Samples along the ray, 1 to 64; fewer where the ray has fewer pixels."), Range(1, 64)] public int traceSteps;
        /// <summary>How far behind the surface that the camera sees geometry is taken to reach. Unit: metres.</summary>
        [Tooltip("How far behind the surface that the camera sees geometry is taken to reach. Unit: metres."), Range(0.0f, 100.0f)] public float traceThicknessMetres;
        /// <summary>Is added to the thickness, as a share of the picture's height at the receiver's distance.</summary>
        [Tooltip("Is added to the thickness, as a share of the picture's height at the receiver's distance."), Range(0.0f, 1.0f)] public float traceThicknessShare;
        /// <summary>Share of the ray, at its end, over which the shadow fades out.</summary>
        [Tooltip("Share of the ray, at its end, over which the shadow fades out."), Range(0.0f, 1.0f)] public float traceEndFade;
        /// <summary>Share of the screen, at each border, over which the shadow of what is seen there fades out.</summary>
        [Tooltip("Share of the screen, at each border, over which the shadow of what is seen there fades out."), Range(0.0f, 0.5f)] public float traceBorderFade;
        /// <summary>Cosine between the surface's normal and the sun below which the shadow fades out, up to a right angle.</summary>
        [Tooltip("Cosine between the surface's normal and the sun below which the shadow fades out, up to a right angle."), Range(0.0f, 1.0f)] public float traceGrazing;
        /// <summary>Length of the ray in pixel footprints below which the shadow fades out with distance, up to half of it. Unit: pixels.</summary>
        [Tooltip("Length of the ray in pixel footprints below which the shadow fades out with distance, up to half of it. Unit: pixels."), Range(0.0f, 1000.0f)] public float traceFadePixels;
        /// <summary>Share of a step by which noise moves a pixel's samples: 0 gives bands, 1 grain.</summary>
        [Tooltip("Share of a step by which noise moves a pixel's samples: 0 gives bands, 1 grain."), Range(0.0f, 1.0f)] public float traceJitter;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static ScreenTraceParameters Default => new ScreenTraceParameters
            { traceLengthMetres = 0.5f, traceHeightShare = 0.0f, traceSteps = 12, traceThicknessMetres = 0.05f,
              traceThicknessShare = 0.0f, traceEndFade = 0.25f, traceBorderFade = 0.05f, traceGrazing = 0.05f,
              traceFadePixels = 2.0f, traceJitter = 1.0f };

        /// <summary>_PenumbraScreenTraceParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.OrLow(traceLengthMetres, 0.0f, 100.0f),
            Bounded.OrLow(traceHeightShare, 0.0f, 1.0f), Bounded.Count(traceSteps, 1, 64),
            Bounded.OrLow(traceThicknessMetres, 0.0f, 100.0f));
        /// <summary>_PenumbraScreenTraceParameters1, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector1 => new Vector4(Bounded.OrLow(traceThicknessShare, 0.0f, 1.0f),
            Bounded.OrLow(traceEndFade, 0.0f, 1.0f), Bounded.OrLow(traceBorderFade, 0.0f, 0.5f),
            Bounded.OrLow(traceGrazing, 0.0f, 1.0f));
        /// <summary>_PenumbraScreenTraceParameters2, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector2 => new Vector4(Bounded.OrLow(traceFadePixels, 0.0f, 1000.0f),
            Bounded.OrLow(traceJitter, 0.0f, 1.0f), 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands)
        {
            commands.SetGlobalVector(Uniform0, Vector0);
            commands.SetGlobalVector(Uniform1, Vector1);
            commands.SetGlobalVector(Uniform2, Vector2);
        }
    }
}
