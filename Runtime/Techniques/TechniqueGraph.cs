using System;

namespace Penumbra
{
    /// <summary>
    /// The passes of a technique and what is between them, as its manifest declares them. `penumbra validate
    /// --emit-graphs` checks graphs and writes them down here; ShadowChain makes of one or more what a frame runs.
    /// </summary>
    internal sealed class TechniqueGraph
    {
        internal const int None = -1;

        internal string name;
        internal GraphTexture[] textures = Array.Empty<GraphTexture>();
        internal GraphBuffer[] buffers = Array.Empty<GraphBuffer>();

        /// <summary>In the order in which they run.</summary>
        internal GraphPass[] passes;

        /// <summary>On in every program that declares them.</summary>
        internal string[] keywords = Array.Empty<string>();

        /// <summary>What the filter at the end of it reads, under the names that the screen's passes find it by.</summary>
        internal GraphBinding[] filterTextures = Array.Empty<GraphBinding>();

        /// <summary>The texture that holds the result; None where a filter has it.</summary>
        internal int visibility = None;

        /// <summary>The texture that is 0 where no penumbra is.</summary>
        internal int mask = None;
    }
}
