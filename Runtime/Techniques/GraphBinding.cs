namespace Penumbra
{
    /// <summary>A program's name for a texture, and the index of that texture in the graph.</summary>
    internal readonly struct GraphBinding
    {
        /// <summary>The program's name for it; null for render targets, which have no name.</summary>
        internal readonly string property;
        internal readonly int index;

        private GraphBinding(string property, int index)
        {
            this.property = property;
            this.index = index;
        }

        internal static GraphBinding Texture(string property, int index) => new GraphBinding(property, index);

        internal static GraphBinding Texture(int index) => new GraphBinding(null, index);
    }
}
