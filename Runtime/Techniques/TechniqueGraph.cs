using System;

namespace Penumbra
{
    /// <summary>
    /// The passes of a technique and the textures between them, as its manifest declares them. `penumbra emit`
    /// checks graphs and writes them into Techniques.txt; ShadowChain combines one or more into what a frame runs.
    /// </summary>
    internal sealed class TechniqueGraph
    {
        internal const int None = -1;

        internal string name;
        internal GraphTexture[] textures = Array.Empty<GraphTexture>();

        /// <summary>The passes in the order in which they run.</summary>
        internal GraphPass[] passes = Array.Empty<GraphPass>();

        /// <summary>The keywords that are enabled in every program that declares them.</summary>
        internal string[] keywords = Array.Empty<string>();

        /// <summary>
        /// The textures that the filter at the graph's end reads, or filters of shaders that draw after the passes,
        /// with the names that the screen-space passes use.
        /// </summary>
        internal GraphBinding[] filterTextures = Array.Empty<GraphBinding>();

        /// <summary>Whether the filter interpolates between the texels of these textures.</summary>
        internal bool filtersLinearly;

        /// <summary>The texture that contains the result; None if a filter computes it.</summary>
        internal int visibility = None;

        /// <summary>
        /// The texture that no pass writes: it holds the visibility of the graphs before this one. None if the graph
        /// needs none.
        /// </summary>
        internal int source = None;

        /// <summary>The texture that is 0 outside penumbrae.</summary>
        internal int mask = None;
    }
}
