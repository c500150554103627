namespace Penumbra
{
    /// <summary>A buffer of 32-bit words: a fixed number plus a number per texel of a texture, or per block of
    /// divisor x divisor texels.</summary>
    internal readonly struct GraphBuffer
    {
        internal readonly string name;
        internal readonly int words;
        internal readonly int wordsPerTexel;

        /// <summary>The texture whose texels are counted: an index into the graph's textures.</summary>
        internal readonly int texture;

        internal readonly int divisor;

        /// <summary>Whether the first three words are the thread group counts of an indirect dispatch.</summary>
        internal readonly bool indirect;

        internal GraphBuffer(string name, int words = 0, int wordsPerTexel = 0, int texture = TechniqueGraph.None,
                             int divisor = 1, bool indirect = false)
        {
            this.name = name;
            this.words = words;
            this.wordsPerTexel = wordsPerTexel;
            this.texture = texture;
            this.divisor = divisor;
            this.indirect = indirect;
        }

        /// <summary>The number of blocks that cover that many texels.</summary>
        internal int Blocks(int texels) => (texels + divisor - 1) / divisor;
    }
}
