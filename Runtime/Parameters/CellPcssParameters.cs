using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraCellPcss.technique.json; do not edit.
    /// <summary>How finely Cell PCSS filters what it does not decide for tiles.</summary>
    [System.Serializable]
    public struct CellPcssParameters
    {
        public static readonly int Uniform0 = Shader.PropertyToID("_PenumbraCellPcssParameters0");

        /// <summary>Cells of the shadow map, or fewer, from the middle of a wide penumbra's filter to its edge, 3 to 5. Unit: cells.</summary>
        [Tooltip("Cells of the shadow map, or fewer, from the middle of a wide penumbra's filter to its edge, 3 to 5. Unit: cells."), Range(3, 5)] public int filterCells;

        /// <summary>The manifest's defaults; a field without one is 0, or the low end of its range.</summary>
        public static CellPcssParameters Default => new CellPcssParameters
            { filterCells = 5 };

        /// <summary>_PenumbraCellPcssParameters0, each component clamped to its range; NaN gives the low end.</summary>
        public Vector4 Vector0 => new Vector4(Bounded.Count(filterCells, 3, 5), 0.0f, 0.0f, 0.0f);

        /// <summary>Sets the uniforms for all later draws. Does not allocate.</summary>
        public void SetGlobal(CommandBuffer commands) => commands.SetGlobalVector(Uniform0, Vector0);
    }
}
