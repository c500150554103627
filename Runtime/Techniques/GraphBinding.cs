namespace Penumbra
{
    /// <summary>
    /// A program's name for a texture or buffer, and the index of that texture or buffer in the graph.
    /// </summary>
    internal readonly struct GraphBinding
    {
        /// <summary>The program's name for it; null for render targets, which have no name.</summary>
        internal readonly string property;

        /// <summary>Whether the index is one of the graph's buffers; otherwise it is one of its textures.</summary>
        internal readonly bool isBuffer;
        internal readonly int index;

        private GraphBinding(string property, bool isBuffer, int index)
        {
            this.property = property;
            this.isBuffer = isBuffer;
            this.index = index;
        }

        internal static GraphBinding Texture(string property, int index) => new GraphBinding(property, false, index);

        internal static GraphBinding Texture(int index) => new GraphBinding(null, false, index);

        internal static GraphBinding Buffer(string property, int index) => new GraphBinding(property, true, index);
    }
}
