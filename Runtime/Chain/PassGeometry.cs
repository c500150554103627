using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>Computes the extents of a pass's steps: mip levels, a cascade's tile, thread groups.</summary>
    internal static class PassGeometry
    {
        /// <summary>
        /// Number of mip levels of a texture. If passes draw it tile by tile, its last level still has a texel per
        /// tile.
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
        /// The rectangle of its target that a step draws, in texels: all of it, or, per cascade of the map, the
        /// cascade's tile.
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

        /// <summary>
        /// Thread groups with one thread per block of divisor x divisor texels of the area; in a pass per cascade, for
        /// one layer of a tile texture.
        /// </summary>
        internal static Vector3Int Groups(in ChainTexture texture, in ShadowFrame frame, bool byCascade, int divisor,
                                          Vector3Int threads)
        {
            Rect area = Area(texture, frame, byCascade, 0, 0);
            bool oneLayer = byCascade && texture.extent == GraphExtent.Tile;
            int depth = oneLayer ? 1 : TextureSize.Drawn(texture, frame).depth;
            return new Vector3Int(Groups((int)area.width, divisor * threads.x), Groups((int)area.height, divisor * threads.y),
                                  Groups(depth, threads.z));
        }

        private static int Groups(int texels, int threads) => (texels + threads - 1) / threads;
    }
}
