using System;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// A texture of a chain: the graph's declaration, and how the passes use it. Equal textures whose lifetimes do
    /// not overlap share a slot.
    /// </summary>
    internal readonly struct ChainTexture : IEquatable<ChainTexture>
    {
        internal readonly GraphExtent extent;
        internal readonly GraphicsFormat format;
        internal readonly int divisor;
        internal readonly int width;
        internal readonly int height;
        internal readonly int depth;
        internal readonly int mips;
        internal readonly int layers;
        internal readonly int samples;

        /// <summary>Whether kernels write the texture.</summary>
        internal readonly bool randomWrite;

        /// <summary>Whether the format is a depth format, which casters are tested against.</summary>
        internal readonly bool isDepth;

        /// <summary>Whether the texture is read with interpolation between texels.</summary>
        internal readonly bool filtered;

        /// <summary>Whether the texture keeps its content between frames.</summary>
        internal readonly bool kept;

        /// <summary>The mip level that this is a copy of; 0 for a whole texture.</summary>
        internal readonly int level;

        internal ChainTexture(in GraphTexture texture, bool randomWrite, bool kept, bool isDepth = false,
                              bool filtered = false)
        {
            extent = texture.extent;
            format = texture.format;
            divisor = texture.divisor;
            width = texture.width;
            height = texture.height;
            depth = texture.depth;
            mips = texture.mips;
            layers = texture.layers;
            samples = texture.samples;
            this.randomWrite = randomWrite;
            this.kept = kept;
            this.isDepth = isDepth;
            this.filtered = filtered;
            level = 0;
        }

        private ChainTexture(in ChainTexture whole, int level)
        {
            this = whole;
            mips = 1;
            kept = false;
            this.level = level;
        }

        /// <summary>A texture of the screen with one 8-bit channel: visibility, or a mask.</summary>
        internal static ChainTexture OfScreen(int divisor) =>
            new ChainTexture(new GraphTexture("", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor), false, false);

        /// <summary>A copy of one of the texture's levels, counted from 0.</summary>
        internal ChainTexture CopyOf(int ofLevel) => new ChainTexture(this, ofLevel);

        /// <summary>
        /// Whether the pipeline cannot lend the texture for a frame: it cannot lend those that are kept, nor those with
        /// mip levels, which URP's render graph textures do not have.
        /// </summary>
        internal bool IsOwned => kept || mips != 1;

        /// <summary>A kept texture equals nothing, not even itself, so that it never shares a slot.</summary>
        public bool Equals(ChainTexture other) =>
            !kept && !other.kept && extent == other.extent && format == other.format && divisor == other.divisor &&
            width == other.width && height == other.height && depth == other.depth && mips == other.mips &&
            layers == other.layers && samples == other.samples && randomWrite == other.randomWrite &&
            filtered == other.filtered && level == other.level;

        public override bool Equals(object other) => other is ChainTexture texture && Equals(texture);
        public override int GetHashCode() => ((int)format * 397) ^ (divisor << 2) ^ (level << 8) ^ ((int)extent << 1);
    }
}
