using System;
using System.Collections.Generic;
using System.Linq;

namespace Penumbra.Editor
{
    /// <summary>
    /// Which programs of Hidden/Penumbra/Shadows a player can ask for: the passes of the chains that the project's
    /// features and Volume profiles can come to, and the keywords that are on in each. The chains themselves say it, so
    /// a new pass needs no change here.
    /// </summary>
    internal sealed class ChainPrograms
    {
        private readonly Dictionary<string, List<IReadOnlyList<string>>> keywordsOf =
            new Dictionary<string, List<IReadOnlyList<string>>>();

        /// <summary>Of each feature alone and under the Volumes.</summary>
        internal static ChainPrograms Of(IEnumerable<PenumbraShadowsSettings> features,
                                         IReadOnlyCollection<PenumbraShadowsVolume> volumes)
        {
            var programs = new ChainPrograms();
            foreach (PenumbraShadowsSettings feature in features)
                foreach (ShadowOptions options in VolumeStacks.Over(feature.Options(), volumes))
                    programs.Add(ShadowChain.Of(options));
            return programs;
        }

        private void Add(ShadowChain chain)
        {
            foreach (ChainStep step in chain.Steps)
            {
                if (step.pass.asset != PenumbraShadows.ShaderFile) continue;
                string pass = step.pass.program;
                if (!keywordsOf.TryGetValue(pass, out List<IReadOnlyList<string>> sets))
                    keywordsOf[pass] = sets = new List<IReadOnlyList<string>>();
                if (!sets.Any(set => set.SequenceEqual(chain.Keywords))) sets.Add(chain.Keywords);
            }
        }

        /// <summary>
        /// Whether a frame draws `pass` by the variant that has, of the `declared` keywords, those on that `enabled`
        /// says.
        /// </summary>
        internal bool Has(string pass, IReadOnlyCollection<string> declared, Predicate<string> enabled) =>
            keywordsOf.TryGetValue(pass, out List<IReadOnlyList<string>> sets) &&
            sets.Any(set => declared.All(name => set.Contains(name) == enabled(name)));
    }
}
