using System;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>What a texture of a chain is as large as, before its divisor.</summary>
    internal enum ChainExtent
    {
        /// <summary>The camera's target, with a slice for each eye where two are drawn at once.</summary>
        Screen,

        /// <summary>The main light's shadow map, all cascades; the same for both eyes.</summary>
        ShadowMap,
    }

    /// <summary>
    /// A texture of a chain: one in `divisor` of its extent's pixels along each axis. Equal ones that are not alive
    /// together share one.
    /// </summary>
    internal readonly struct ChainTexture : IEquatable<ChainTexture>
    {
        internal readonly ChainExtent extent;
        internal readonly int divisor;
        internal readonly GraphicsFormat format;

        /// <summary>Compute shaders write it.</summary>
        internal readonly bool randomWrite;

        internal ChainTexture(ChainExtent extent, int divisor, GraphicsFormat format, bool randomWrite = false)
        {
            this.extent = extent;
            this.divisor = divisor;
            this.format = format;
            this.randomWrite = randomWrite;
        }

        /// <summary>One channel of 8 bits over the screen: visibility, or a mask.</summary>
        internal static ChainTexture OfScreen(int divisor) =>
            new ChainTexture(ChainExtent.Screen, divisor, GraphicsFormat.R8_UNorm);

        /// <summary>Size along one axis: rounded up, so that the last pixels of an odd extent have one too.</summary>
        internal int Size(int extentSize) => Math.Max(1, (extentSize + divisor - 1) / divisor);

        public bool Equals(ChainTexture other) => extent == other.extent && divisor == other.divisor &&
                                                  format == other.format && randomWrite == other.randomWrite;
        public override bool Equals(object other) => other is ChainTexture texture && Equals(texture);
        public override int GetHashCode() => ((int)format * 397) ^ (divisor << 2) ^ ((int)extent << 1);
    }
}
