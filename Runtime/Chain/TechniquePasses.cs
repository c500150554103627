using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>
    /// Graphs of the techniques that are more than a filter of the shadow map. One that ends in a filter runs before the
    /// passes over the screen, which find its textures by name; one that ends in a visibility runs in their place.
    /// </summary>
    internal static class TechniquePasses
    {
        internal static readonly Dictionary<ShadowTechnique, TechniqueGraph> Graphs =
            new Dictionary<ShadowTechnique, TechniqueGraph>();
    }
}
