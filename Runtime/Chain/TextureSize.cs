using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>The size in texels of a mip level of a texture.</summary>
    internal readonly struct TextureSize
    {
        internal readonly int width;
        internal readonly int height;

        /// <summary>
        /// The depth of a 3D texture; otherwise the number of layers, which for textures of the screen without layers
        /// is one for each eye.
        /// </summary>
        internal readonly int depth;

        private readonly bool isVolume;

        private TextureSize(int width, int height, int depth, bool isVolume)
        {
            this.width = width;
            this.height = height;
            this.depth = depth;
            this.isVolume = isVolume;
        }

        /// <summary>
        /// The size of the whole texture, rounded up, so that it covers an extent that is not a multiple of the
        /// divisor.
        /// </summary>
        internal static TextureSize Of(in ChainTexture texture, in ShadowFrame frame) => Of(texture, frame, 1.0f, 1.0f);

        /// <summary>
        /// The size of the part of the texture that is drawn: dynamic resolution leaves part of the screen's textures
        /// unused.
        /// </summary>
        internal static TextureSize Drawn(in ChainTexture texture, in ShadowFrame frame) =>
            texture.extent == GraphExtent.Screen ? Of(texture, frame, frame.widthScale, frame.heightScale)
                                                 : Of(texture, frame);

        private static TextureSize Of(in ChainTexture texture, in ShadowFrame frame, float widthScale,
                                      float heightScale)
        {
            TextureSize extent = Extent(texture, frame);
            int width = Mathf.CeilToInt(Divided(extent.width, texture.divisor) * widthScale);
            int height = Mathf.CeilToInt(Divided(extent.height, texture.divisor) * heightScale);
            return new TextureSize(width, height, extent.depth, extent.isVolume).At(texture.level);
        }

        private static TextureSize Extent(in ChainTexture texture, in ShadowFrame frame)
        {
            switch (texture.extent)
            {
                case GraphExtent.Map:
                    return new TextureSize(frame.layout.Width, frame.layout.Height, texture.layers, false);
                case GraphExtent.Tile:
                    return new TextureSize(frame.layout.TileResolution, frame.layout.TileResolution,
                                           frame.layout.Cascades, false);
                case GraphExtent.Fixed:
                    return texture.depth > 1 ? new TextureSize(texture.width, texture.height, texture.depth, true)
                                             : new TextureSize(texture.width, texture.height, texture.layers, false);
                default:
                    return new TextureSize(frame.width, frame.height,
                                           texture.layers > 1 ? texture.layers : Math.Max(1, frame.views), false);
            }
        }

        private static int Divided(int extent, int divisor) => Math.Max(1, (extent + divisor - 1) / divisor);

        /// <summary>The size of the level `mip` levels below this one.</summary>
        internal TextureSize At(int mip) =>
            new TextureSize(Math.Max(1, width >> mip), Math.Max(1, height >> mip),
                            isVolume ? Math.Max(1, depth >> mip) : depth, isVolume);

        /// <summary>Number of mip levels down to one texel.</summary>
        internal int Levels
        {
            get
            {
                int largest = Math.Max(Math.Max(width, height), isVolume ? depth : 1);
                int levels = 1;
                while (largest >> levels > 0) ++levels;
                return levels;
            }
        }

        /// <summary>Width, height and their inverses, the layout of size uniforms.</summary>
        internal Vector4 Uniform => new Vector4(width, height, 1.0f / width, 1.0f / height);
    }
}
