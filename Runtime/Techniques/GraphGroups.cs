namespace Penumbra
{
    /// <summary>The thread group counts of a kernel's dispatch.</summary>
    internal readonly struct GraphGroups
    {
        /// <summary>Fixed counts; all 0 if they are not fixed.</summary>
        internal readonly int x;
        internal readonly int y;
        internal readonly int z;

        /// <summary>The texture with one thread per texel, or per block of divisor x divisor of them.</summary>
        internal readonly int texelsOf;
        internal readonly int divisor;

        private GraphGroups(int x, int y, int z, int texelsOf, int divisor = 1)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.texelsOf = texelsOf;
            this.divisor = divisor;
        }

        internal static GraphGroups Fixed(int x, int y, int z) => new GraphGroups(x, y, z, TechniqueGraph.None);

        internal static GraphGroups TexelsOf(int texture, int divisor = 1) =>
            new GraphGroups(0, 0, 0, texture, divisor);
    }
}
