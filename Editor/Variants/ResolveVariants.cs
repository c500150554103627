using System.Collections.Generic;

namespace Penumbra.Editor
{
    /// <summary>
    /// Which variants of Hidden/Penumbra/Shadows a player can ask for: those of the options that the project's features
    /// and Volume profiles can come to.
    /// </summary>
    internal sealed class ResolveVariants
    {
        private readonly HashSet<(ShadowTechnique technique, bool mask)> used =
            new HashSet<(ShadowTechnique technique, bool mask)>();

        private void Add(in ShadowOptions options)
        {
            bool mask = false;
            foreach (ShadowPass pass in ShadowPassList.All) mask |= pass is MaskPass && pass.IsNeeded(options);
            used.Add((options.technique, mask));
        }

        /// <summary>All that `feature` alone and under each Volume profile can be.</summary>
        internal static ResolveVariants Of(IEnumerable<PenumbraShadowsSettings> features,
                                           IReadOnlyCollection<PenumbraShadowsVolume> volumes)
        {
            var variants = new ResolveVariants();
            foreach (PenumbraShadowsSettings feature in features)
                foreach (ShadowOptions options in UnderVolumes(feature.Options(), volumes)) variants.Add(options);
            return variants;
        }

        // The feature's own among them. Two Volumes may blend: a technique of one meets the mask of another, so both are combined freely.
        private static IEnumerable<ShadowOptions> UnderVolumes(ShadowOptions feature,
                                                               IReadOnlyCollection<PenumbraShadowsVolume> volumes)
        {
            var reached = new HashSet<ShadowOptions> { feature };
            for (bool grows = true; grows;)
            {
                int before = reached.Count;
                foreach (ShadowOptions options in new List<ShadowOptions>(reached))
                    foreach (PenumbraShadowsVolume volume in volumes)
                        reached.Add(KeywordsOnly(volume.Over(options)));
                grows = reached.Count > before;
            }
            return reached;
        }

        // Of what chooses a variant; numbers in between would make the set endless.
        private static ShadowOptions KeywordsOnly(ShadowOptions options)
        {
            ShadowOptions choice = ShadowPresets.Options(QualityPreset.Custom);
            choice.technique = options.technique;
            choice.mask = options.mask;
            choice.angularDiameterDegrees = options.angularDiameterDegrees > 0.0f ? AngularDiameter.SunDegrees : 0.0f;
            return choice;
        }

        /// <summary>`enabled` says which keywords a variant has.</summary>
        internal bool Uses(System.Predicate<string> enabled)
        {
            bool mask = enabled(TechniqueKeywords.Mask);
            for (int technique = 0; technique < TechniqueKeywords.Names.Length; ++technique)
                if (Is(technique, enabled)) return used.Contains(((ShadowTechnique)technique, mask));
            return false;
        }

        private static bool Is(int technique, System.Predicate<string> enabled)
        {
            for (int other = 0; other < TechniqueKeywords.Names.Length; ++other)
            {
                string name = TechniqueKeywords.Names[other];
                if (name != null && enabled(name) != (other == technique)) return false;
            }
            return true;
        }
    }
}
