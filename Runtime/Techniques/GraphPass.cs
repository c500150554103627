using System;

namespace Penumbra
{
    internal enum PassKind
    {
        /// <summary>A pass of a shader, drawn over all of its targets.</summary>
        Raster,

        /// <summary>A kernel of a compute shader.</summary>
        Compute,
    }

    /// <summary>When a pass runs: the later ones more often.</summary>
    internal enum PassFrequency
    {
        /// <summary>Once, as long as what it has written is there.</summary>
        Bake,

        /// <summary>For each cascade that was drawn anew.</summary>
        Cascade,

        Frame,
    }

    /// <summary>A pass of a graph.</summary>
    internal sealed class GraphPass
    {
        internal PassKind kind;

        /// <summary>Path in the package of its shader or compute shader.</summary>
        internal string asset;

        /// <summary>The shader's pass, or the compute shader's kernel.</summary>
        internal string program;

        internal PassFrequency runs = PassFrequency.Frame;
        internal GraphBinding[] reads = Array.Empty<GraphBinding>();

        /// <summary>Of a raster pass its targets, in order.</summary>
        internal GraphBinding[] writes = Array.Empty<GraphBinding>();

        /// <summary>Once for each mip level but the first, from the level before.</summary>
        internal bool eachMip;

        /// <summary>Of a kernel.</summary>
        internal GraphGroups groups;

        internal bool Writes(bool isBuffer, int index) => Has(writes, isBuffer, index);

        internal bool Reads(bool isBuffer, int index) =>
            Has(reads, isBuffer, index) || isBuffer && kind == PassKind.Compute && groups.indirect == index;

        private static bool Has(GraphBinding[] bindings, bool isBuffer, int index)
        {
            foreach (GraphBinding binding in bindings)
                if (binding.isBuffer == isBuffer && binding.index == index) return true;
            return false;
        }
    }
}
