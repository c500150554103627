namespace Penumbra
{
    /// <summary>Words of 32 bits: a fixed number, and so many for each texel of a texture.</summary>
    internal readonly struct GraphBuffer
    {
        internal readonly string name;
        internal readonly int words;
        internal readonly int wordsPerTexel;

        /// <summary>Whose texels count; of the graph's textures.</summary>
        internal readonly int texture;

        /// <summary>Its first three words are the numbers of groups of a dispatch.</summary>
        internal readonly bool indirect;

        internal GraphBuffer(string name, int words = 0, int wordsPerTexel = 0, int texture = TechniqueGraph.None,
                             bool indirect = false)
        {
            this.name = name;
            this.words = words;
            this.wordsPerTexel = wordsPerTexel;
            this.texture = texture;
            this.indirect = indirect;
        }
    }
}
