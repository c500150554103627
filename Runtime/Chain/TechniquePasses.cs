using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>
    /// Graphs of the techniques that need more than a filter of the shadow map. A graph that ends in a filter runs
    /// before the screen-space passes, which read its textures by name; one that outputs a visibility texture
    /// replaces those passes.
    /// </summary>
    internal static class TechniquePasses
    {
        internal static readonly Dictionary<ShadowTechnique, TechniqueGraph> Graphs =
            new Dictionary<ShadowTechnique, TechniqueGraph>();
    }
}
