namespace Penumbra
{
    /// <summary>How many groups of threads a kernel is started with.</summary>
    internal readonly struct GraphGroups
    {
        /// <summary>All 0: not fixed.</summary>
        internal readonly int x;
        internal readonly int y;
        internal readonly int z;

        /// <summary>One thread for each texel of this texture.</summary>
        internal readonly int texelsOf;

        /// <summary>As this buffer says.</summary>
        internal readonly int indirect;

        private GraphGroups(int x, int y, int z, int texelsOf, int indirect)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.texelsOf = texelsOf;
            this.indirect = indirect;
        }

        internal static GraphGroups Fixed(int x, int y, int z) =>
            new GraphGroups(x, y, z, TechniqueGraph.None, TechniqueGraph.None);

        internal static GraphGroups TexelsOf(int texture) => new GraphGroups(0, 0, 0, texture, TechniqueGraph.None);

        internal static GraphGroups Indirect(int buffer) => new GraphGroups(0, 0, 0, TechniqueGraph.None, buffer);
    }
}
