using System;

namespace Penumbra
{
    internal enum PassKind
    {
        /// <summary>A full-screen draw of a shader pass into all of its targets.</summary>
        Raster,

        /// <summary>A shader pass that draws the casters, per cascade or as seen by the camera.</summary>
        Casters,

        /// <summary>A kernel of a compute shader.</summary>
        Compute,

        /// <summary>The target is filled with 1, without a program. No manifest has such a pass.</summary>
        Lit,
    }

    /// <summary>How often a pass runs, from seldom to often.</summary>
    internal enum PassFrequency
    {
        /// <summary>The pass runs once, until the textures that it writes are lost.</summary>
        Bake,

        /// <summary>The pass runs once per cascade that was redrawn.</summary>
        Cascade,

        Frame,
    }

    /// <summary>A pass of a graph.</summary>
    internal sealed class GraphPass
    {
        internal PassKind kind;

        /// <summary>Path of its shader or compute shader in the package.</summary>
        internal string asset;

        /// <summary>The shader's pass, or the compute shader's kernel.</summary>
        internal string program;

        internal PassFrequency runs = PassFrequency.Frame;
        internal GraphBinding[] reads = Array.Empty<GraphBinding>();

        /// <summary>
        /// Textures that its program declares and this pass does not bind: their sizes are 0, by which the program
        /// knows that it has none.
        /// </summary>
        internal string[] absent = Array.Empty<string>();

        /// <summary>
        /// The textures that the pass writes; for a pass that draws, in the order of its render targets.
        /// </summary>
        internal GraphBinding[] writes = Array.Empty<GraphBinding>();

        /// <summary>The textures that another pass has written before and a kernel changes.</summary>
        internal GraphBinding[] updates = Array.Empty<GraphBinding>();

        /// <summary>The depth texture that casters are tested against and write to; -1 without one.</summary>
        internal int depth = -1;

        /// <summary>Whether casters are tested against the shadow map.</summary>
        internal bool testsShadowMap;

        /// <summary>Whether casters are those that blend, in place of those that the shadow map holds.</summary>
        internal bool blended;

        /// <summary>
        /// Whether the pass runs once per mip level of its target except the first, reading the previous level. Kernels
        /// do not.
        /// </summary>
        internal bool eachMip;

        /// <summary>The thread group counts of a kernel.</summary>
        internal GraphGroups groups;

        internal bool Writes(int texture) => Has(writes, texture) || Has(updates, texture) || depth == texture;

        internal bool Reads(int texture) => Has(reads, texture);

        private static bool Has(GraphBinding[] bindings, int texture)
        {
            foreach (GraphBinding binding in bindings)
                if (binding.index == texture) return true;
            return false;
        }
    }
}
