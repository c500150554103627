namespace Penumbra
{
    /// <summary>What a program calls a texture or buffer, and which one of its graph's it is.</summary>
    internal readonly struct GraphBinding
    {
        /// <summary>Null: a target, which has no name.</summary>
        internal readonly string property;

        /// <summary>Among the graph's buffers, else among its textures.</summary>
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
