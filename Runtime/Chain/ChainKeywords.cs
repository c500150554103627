using System.Collections.Generic;
using System.Linq;

namespace Penumbra
{
    /// <summary>Shader keywords of chains: the techniques' and the graphs'.</summary>
    internal static class ChainKeywords
    {
        /// <summary>
        /// The keyword of kernels that can draw both eyes at once; where a kernel declares it, both eyes are drawn at
        /// once.
        /// </summary>
        internal const string BothEyes = "_PENUMBRA_BOTH_EYES";

        /// <summary>All keywords that a program of a chain may declare.</summary>
        internal static IReadOnlyList<string> All
        {
            get
            {
                List<string> all = Of(null, ChainGraphs.All);
                all.AddRange(OfTechniques.Except(all));
                all.Add(BothEyes);
                return all;
            }
        }

        internal static IEnumerable<string> OfTechniques =>
            TechniqueTable.Entries.Select(technique => technique.keyword).Where(keyword => keyword != null).Distinct();

        /// <summary>The chain's keywords, each once; nulls are skipped.</summary>
        internal static List<string> Of(string technique, IEnumerable<TechniqueGraph> graphs)
        {
            var keywords = new List<string>();
            if (technique != null) keywords.Add(technique);
            foreach (TechniqueGraph graph in graphs)
                foreach (string name in graph.keywords)
                    if (!keywords.Contains(name)) keywords.Add(name);
            return keywords;
        }
    }
}
