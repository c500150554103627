using UnityEngine;

namespace Penumbra.Samples.FarShadows
{
    /// <summary>
    /// Computes the heights of a valley between two ridges, a sum of waves: the same on every machine. The valley runs
    /// along z; its floor is in the middle, at x = 0.
    /// </summary>
    internal static class ValleyHeights
    {
        /// <summary>Width and depth; the valley's middle is the origin.</summary>
        internal const float SideMetres = 4000.0f;

        /// <summary>Height above the lowest possible ground.</summary>
        internal const float TopMetres = 900.0f;

        /// <summary>Samples on a side, a power of two plus one, as terrains need.</summary>
        internal const int Samples = 513;

        private const float RidgeMetres = 1100.0f;  // distance of the ridges from the middle
        private const float FloorMetres = 60.0f;

        /// <summary>The height at a world position, 0 to TopMetres.</summary>
        internal static float At(float x, float z)
        {
            // The ridges bend, and their tops rise and fall.
            float bent = x + 140.0f * Mathf.Sin(z * 0.0021f) + 60.0f * Mathf.Sin(z * 0.0057f + 1.0f);
            float ridge = Mathf.Exp(-Squared((Mathf.Abs(bent) - RidgeMetres) / 420.0f));
            float tops = 540.0f + 80.0f * Mathf.Sin(z * 0.0043f + (bent > 0.0f ? 0.7f : 2.9f)) +
                         50.0f * Mathf.Sin(z * 0.0131f + bent * 0.0023f);
            float rough = 9.0f * Mathf.Sin(x * 0.021f + z * 0.013f) * Mathf.Sin(z * 0.017f - x * 0.009f);
            // The valley's floor is even enough to stand on.
            float high = FloorMetres + ridge * tops + rough * (0.15f + ridge);
            return Mathf.Clamp(high, 0.0f, TopMetres);
        }

        /// <summary>The heights for TerrainData.SetHeights: rows along z, 0 to 1.</summary>
        internal static float[,] Sampled()
        {
            var heights = new float[Samples, Samples];
            for (int z = 0; z < Samples; ++z)
                for (int x = 0; x < Samples; ++x) heights[z, x] = At(Place(x), Place(z)) / TopMetres;
            return heights;
        }

        // The first and last samples lie on the terrain's edges.
        private static float Place(int sample) => SideMetres * (sample / (Samples - 1.0f) - 0.5f);

        private static float Squared(float value) => value * value;
    }
}
