namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// Random numbers in [0, 1) that depend only on the seed, on every machine and version of Unity: the finalizer of
    /// MurmurHash3 applied to a counter (Appleby 2011).
    /// </summary>
    internal sealed class SeededChance
    {
        private readonly uint start;
        private uint count;

        internal SeededChance(int seed) { start = Mixed(unchecked((uint)seed * 0x9e3779b9u)); }

        internal float Next() => (Mixed(unchecked(start + ++count)) >> 8) * (1.0f / (1 << 24));

        private static uint Mixed(uint bits)
        {
            unchecked
            {
                bits = (bits ^ (bits >> 16)) * 0x85ebca6bu;
                bits = (bits ^ (bits >> 13)) * 0xc2b2ae35u;
                return bits ^ (bits >> 16);
            }
        }
    }
}
