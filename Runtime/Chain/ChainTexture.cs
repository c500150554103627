using System;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// A texture of a chain: what a graph declares, and what its passes make of it. Equal ones that are not alive
    /// together share one.
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

        /// <summary>Kernels write it.</summary>
        internal readonly bool randomWrite;

        /// <summary>Of a format of depth, which casters are tested against.</summary>
        internal readonly bool isDepth;

        /// <summary>Holds what it has from frame to frame.</summary>
        internal readonly bool kept;

        /// <summary>A mip level of such a texture alone; 0: the whole texture.</summary>
        internal readonly int level;

        internal ChainTexture(in GraphTexture texture, bool randomWrite, bool kept, bool isDepth = false)
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
            level = 0;
        }

        private ChainTexture(in ChainTexture whole, int level)
        {
            this = whole;
            mips = 1;
            kept = false;
            this.level = level;
        }

        /// <summary>One channel of 8 bits over the screen: visibility, or a mask.</summary>
        internal static ChainTexture OfScreen(int divisor) =>
            new ChainTexture(new GraphTexture("", GraphExtent.Screen, GraphicsFormat.R8_UNorm, divisor), false, false);

        /// <summary>For a copy of one of its levels, from 0.</summary>
        internal ChainTexture CopyOf(int ofLevel) => new ChainTexture(this, ofLevel);

        /// <summary>
        /// The pipeline does not lend such a texture for a frame: what is kept, and what has mip levels, which URP's
        /// textures of the render graph have not.
        /// </summary>
        internal bool IsOwned => kept || mips != 1;

        /// <summary>What is kept equals nothing, not even itself: nobody shares it.</summary>
        public bool Equals(ChainTexture other) =>
            !kept && !other.kept && extent == other.extent && format == other.format && divisor == other.divisor &&
            width == other.width && height == other.height && depth == other.depth && mips == other.mips &&
            layers == other.layers && samples == other.samples && randomWrite == other.randomWrite &&
            level == other.level;

        public override bool Equals(object other) => other is ChainTexture texture && Equals(texture);
        public override int GetHashCode() => ((int)format * 397) ^ (divisor << 2) ^ (level << 8) ^ ((int)extent << 1);
    }
}
