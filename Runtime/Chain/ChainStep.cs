namespace Penumbra
{
    /// <summary>A texture of a step: an index into ShadowChain.Slots.</summary>
    internal struct ChainBinding
    {
        /// <summary>The Shader.PropertyToID of the name; 0 for render targets.</summary>
        internal int property;

        /// <summary>The property that receives the size of a texture that is read.</summary>
        internal int sizeProperty;

        internal int index;

        /// <summary>
        /// The copies of a texture whose mip levels the step generates: per level, the slot of the copy that it reads,
        /// since a texture cannot be read while one of its levels is drawn. Null for other textures.
        /// </summary>
        internal int[] levels;
    }

    /// <summary>Two slots that are swapped after every frame.</summary>
    internal struct ChainHistory
    {
        internal int now;
        internal int before;
    }

    /// <summary>A pass of a chain, with the textures that it reads and writes.</summary>
    internal sealed class ChainStep
    {
        internal GraphPass pass;
        internal ChainBinding[] reads;

        /// <summary>
        /// The properties of the pass's absent textures, and those that receive their sizes, which are 0.
        /// </summary>
        internal int[] absent;
        internal int[] absentSizes;

        /// <summary>The pass's writes, then its updates.</summary>
        internal ChainBinding[] writes;

        /// <summary>The texture with a thread per texel; None for a fixed number of groups.</summary>
        internal int threadsOf = ShadowChain.None;

        /// <summary>The slot of the casters' own depth texture; None for other passes.</summary>
        internal int depth = ShadowChain.None;

        internal bool ByCascade => pass.runs == PassFrequency.Cascade;

        /// <summary>
        /// Whether the kernel has no thread per texel and so may not write all texels, which are cleared first. Passes
        /// per cascade are not cleared, because they must keep the other cascades' texels.
        /// </summary>
        internal bool IsSparse => pass.kind == PassKind.Compute && threadsOf == ShadowChain.None && !ByCascade;

        /// <summary>
        /// The first texture that the step writes, or the depth texture of casters that write no other.
        /// </summary>
        internal int Target => writes.Length > 0 ? writes[0].index : depth;
    }
}
