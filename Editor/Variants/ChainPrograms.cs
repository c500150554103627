using System;
using System.Collections.Generic;
using System.Linq;

namespace Penumbra.Editor
{
    /// <summary>
    /// The programs of the package's shaders that a player can use: the passes of all chains that the project's
    /// features and Volume profiles can select, each with its enabled keywords. They are derived from the chains
    /// themselves, so that a new pass needs no change here.
    /// </summary>
    internal sealed class ChainPrograms
    {
        private readonly Dictionary<(string asset, string pass), List<IReadOnlyList<string>>> keywordsOf =
            new Dictionary<(string, string), List<IReadOnlyList<string>>>();

        /// <summary>The programs of each feature, alone and with the Volumes' overrides.</summary>
        internal static ChainPrograms Of(IEnumerable<PenumbraShadowsSettings> features,
                                         IReadOnlyCollection<PenumbraShadowsVolume> volumes)
        {
            var programs = new ChainPrograms();
            foreach (PenumbraShadowsSettings feature in features)
                foreach (ShadowOptions options in VolumeStacks.Over(feature.Options(), volumes))
                {
                    programs.AddWithSubstitutes(options);
                    if (options.farShadows == FarShadowMode.Off) continue;
                    // These options are drawn in scenes without a FarShadowGround.
                    ShadowOptions withoutGround = options;
                    withoutGround.farShadows = FarShadowMode.Off;
                    programs.AddWithSubstitutes(withoutGround);
                }
            return programs;
        }

        // The chains include those that ChainDraw falls back to on some devices.
        private void AddWithSubstitutes(ShadowOptions options)
        {
            do Add(ShadowChain.Of(options));
            while (ChainSubstitute.TryGet(options, out options));
        }

        private void Add(ShadowChain chain)
        {
            foreach (ChainStep step in chain.Steps)
            {
                (string, string) pass = (step.pass.asset, step.pass.program);
                if (!keywordsOf.TryGetValue(pass, out List<IReadOnlyList<string>> sets))
                    keywordsOf[pass] = sets = new List<IReadOnlyList<string>>();
                if (!sets.Any(set => set.SequenceEqual(chain.Keywords))) sets.Add(chain.Keywords);
            }
        }

        /// <summary>
        /// Whether a frame uses the variant of `pass`, a pass or kernel of the file `asset`, whose enabled keywords
        /// among `declared` are those for which `enabled` is true.
        /// </summary>
        internal bool Has(string asset, string pass, IReadOnlyCollection<string> declared, Predicate<string> enabled) =>
            keywordsOf.TryGetValue((asset, pass), out List<IReadOnlyList<string>> sets) &&
            sets.Any(set => declared.All(name => set.Contains(name) == enabled(name)));
    }
}
