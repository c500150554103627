using System;

namespace Penumbra
{
    internal enum PassKind
    {
        /// <summary>A pass of a shader, drawn over all of its targets.</summary>
        Raster,

        /// <summary>A pass of a shader that draws the casters: for each cascade, or as the camera sees them.</summary>
        Casters,

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

        /// <summary>Of a pass that draws its targets, in order.</summary>
        internal GraphBinding[] writes = Array.Empty<GraphBinding>();

        /// <summary>Of casters: the texture that they are tested against and whose depth they write; -1: none.</summary>
        internal int depth = -1;

        /// <summary>Of casters: they are tested against the shadow map.</summary>
        internal bool testsShadowMap;

        /// <summary>Once for each mip level but the first, from the level before.</summary>
        internal bool eachMip;

        /// <summary>Of a kernel.</summary>
        internal GraphGroups groups;

        internal bool Writes(bool isBuffer, int index) =>
            Has(writes, isBuffer, index) || !isBuffer && depth == index;

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
