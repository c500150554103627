using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>Keywords of Hidden/Penumbra/Shadows: the techniques' and the passes'.</summary>
    internal static class ChainKeywords
    {
        /// <summary>All that a pass of the shader may declare.</summary>
        internal static readonly IReadOnlyList<string> All = Of(TechniqueTable.Keywords, ShadowPassList.All);

        /// <summary>The ones there are; null stands for none.</summary>
        internal static List<string> Of(IEnumerable<string> techniques, IEnumerable<ShadowPass> passes)
        {
            var keywords = new List<string>();
            foreach (string name in techniques)
                if (name != null) keywords.Add(name);
            foreach (ShadowPass pass in passes)
                if (pass.Keyword != null) keywords.Add(pass.Keyword);
            return keywords;
        }
    }
}
