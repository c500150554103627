namespace Penumbra
{
    /// <summary>A texture or buffer of a step: an index into ShadowChain.Slots or ShadowChain.Buffers.</summary>
    internal struct ChainBinding
    {
        /// <summary>As Shader.PropertyToID has it; of targets 0.</summary>
        internal int property;

        /// <summary>Of a texture that is read: what is told its size.</summary>
        internal int sizeProperty;

        internal bool isBuffer;
        internal int index;

        /// <summary>
        /// Of a texture whose mip levels the step makes: by level, the slot of the copy that it reads. A texture cannot
        /// be read while one of its levels is drawn. Null elsewhere.
        /// </summary>
        internal int[] levels;
    }

    /// <summary>Two slots that change places after every frame.</summary>
    internal struct ChainHistory
    {
        internal int now;
        internal int before;
    }

    /// <summary>A pass of a chain, with what it reads and writes there.</summary>
    internal sealed class ChainStep
    {
        internal GraphPass pass;
        internal ChainBinding[] reads;
        internal ChainBinding[] writes;

        /// <summary>Whose texels are a kernel's threads, or which buffer holds its numbers of groups; else None.</summary>
        internal int threadsOf = ShadowChain.None;
        internal int indirect = ShadowChain.None;

        /// <summary>Of casters: the slot of their own depth; else None.</summary>
        internal int depth = ShadowChain.None;

        internal bool ByCascade => pass.runs == PassFrequency.Cascade;

        /// <summary>
        /// A kernel that has not a thread for each texel may leave some out. In a pass by cascade the other cascades' are
        /// among them.
        /// </summary>
        internal bool IsSparse => pass.kind == PassKind.Compute && threadsOf == ShadowChain.None && !ByCascade;

        /// <summary>
        /// The first texture that it writes, of casters without another one their depth; None where it writes buffers
        /// alone.
        /// </summary>
        internal int Target
        {
            get
            {
                foreach (ChainBinding write in writes)
                    if (!write.isBuffer) return write.index;
                return depth;
            }
        }
    }
}
