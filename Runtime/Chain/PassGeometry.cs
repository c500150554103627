using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>Where the steps of a pass work: mip levels, a cascade's tile, groups of threads.</summary>
    internal static class PassGeometry
    {
        /// <summary>
        /// Levels that there are of a texture. Of one that is made tile by tile, no tile is smaller than a texel in the
        /// last.
        /// </summary>
        internal static int Levels(in ChainTexture texture, in ShadowFrame frame, bool byCascade)
        {
            int all = TextureSize.Drawn(texture, frame).Levels;
            int levels = texture.mips == 0 ? all : Math.Min(texture.mips, all);
            if (!byCascade || frame.layout.Cascades == 1 || texture.extent != GraphExtent.Map) return levels;
            while (levels > 1 && frame.layout.TileResolution / (texture.divisor << (levels - 1)) < 1) --levels;
            return levels;
        }

        /// <summary>
        /// What a step draws of its target in texels: all of it, or of the map, cascade by cascade, the cascade's tile.
        /// </summary>
        internal static Rect Area(in ChainTexture texture, in ShadowFrame frame, bool byCascade, int cascade, int mip)
        {
            if (!byCascade || texture.extent != GraphExtent.Map)
            {
                TextureSize size = TextureSize.Drawn(texture, frame).At(mip);
                return new Rect(0.0f, 0.0f, size.width, size.height);
            }
            int scale = texture.divisor << mip;
            int tile = frame.layout.TileResolution;
            int side = Math.Max(1, tile / scale);
            return new Rect(cascade % 2 * tile / scale, cascade / 2 * tile / scale, side, side);
        }

        /// <summary>Groups that give each texel of the area one thread; in a pass by cascade one layer of a tile's.</summary>
        internal static Vector3Int Groups(in ChainTexture texture, in ShadowFrame frame, bool byCascade, int mip,
                                          Vector3Int threads)
        {
            Rect area = Area(texture, frame, byCascade, 0, mip);
            bool oneLayer = byCascade && texture.extent == GraphExtent.Tile;
            int depth = oneLayer ? 1 : TextureSize.Drawn(texture, frame).At(mip).depth;
            return new Vector3Int(Groups((int)area.width, threads.x), Groups((int)area.height, threads.y),
                                  Groups(depth, threads.z));
        }

        private static int Groups(int texels, int threads) => (texels + threads - 1) / threads;
    }
}
