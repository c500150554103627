using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The layout of URP's main light shadow map: square tiles in two columns, row by row, each as large as fits into
    /// a square map of the asset's resolution. With two cascades the map is only half as high.
    /// <code>
    ///   1: | 0 |     2: | 0 1 |     3, 4: | 0 1 |
    ///                                     | 2 3 |
    /// </code>
    /// <para>Sizes in texels, rectangles in atlas UV. Source: ShadowUtils.GetMaxTileResolutionInAtlas and the main
    /// light's caster pass of URP 14 to 17. Counts and resolutions are clamped to their ranges.</para>
    /// </summary>
    public readonly struct AtlasLayout
    {
        public const int MostCascades = 4;
        public const int SmallestResolution = 8;
        public const int LargestResolution = 16384;

        public readonly int Width;
        public readonly int Height;
        public readonly int TileResolution;
        public readonly int Cascades;

        /// <param name="resolution">The asset's main light shadow resolution: the map's width.</param>
        /// <param name="cascades">1 to 4.</param>
        public AtlasLayout(int resolution, int cascades)
        {
            Cascades = Bounded.Count(cascades, 1, MostCascades);
            Width = Bounded.Count(resolution, SmallestResolution, LargestResolution);
            Height = Cascades == 2 ? Width / 2 : Width;
            TileResolution = Width;
            while (Width / TileResolution * Width / TileResolution < Cascades) TileResolution /= 2;
        }

        /// <summary>1/width, 1/height, width, height: _PenumbraMainLightAtlasTexelSize.</summary>
        public Vector4 TexelSize => new Vector4((float)(1.0 / Width), (float)(1.0 / Height), Width, Height);

        /// <summary>
        /// x, y, width and height of a cascade's tile in atlas UV; the index is clamped to the existing cascades.
        /// </summary>
        public Vector4 Tile(int cascade)
        {
            var index = Bounded.Count(cascade, 0, Cascades - 1);
            var height = (double)TileResolution / Height;
            return new Vector4((float)(index % 2 * TileWidth), (float)(index / 2 * height), (float)TileWidth,
                               (float)height);
        }

        /// <summary>Width of every tile in atlas UV.</summary>
        internal double TileWidth => (double)TileResolution / Width;
    }
}
