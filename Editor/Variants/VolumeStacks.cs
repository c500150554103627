using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// All options that a feature can have with a project's Volumes. Where Volumes overlap, each parameter has the
    /// value of the last Volume that overrides it; the order depends on places and priorities, so every order is
    /// considered. Unity applies a bool or enum as soon as a Volume starts to fade in.
    /// </summary>
    internal static class VolumeStacks
    {
        /// <summary>
        /// The combinations, each once, including the feature's own; numbers that do not affect the program are set to
        /// a preset's.
        /// </summary>
        internal static IReadOnlyCollection<ShadowOptions> Over(in ShadowOptions feature,
                                                                IEnumerable<PenumbraShadowsVolume> volumes)
        {
            var reached = new HashSet<ShadowOptions>();
            var stack = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
            foreach (VolumeOverrides overrides in Meetings(volumes.SelectMany(VolumeOverrides.Of)))
            {
                overrides.Fill(stack);
                reached.Add(ChoicesOnly(stack.Over(feature)));
            }
            CoreUtils.Destroy(stack);
            return reached;
        }

        // The overrides of no Volume, of one Volume, and of each Volume after every combination found before.
        private static IEnumerable<VolumeOverrides> Meetings(IEnumerable<VolumeOverrides> volumes)
        {
            VolumeOverrides[] each = volumes.Distinct().ToArray();
            var met = new HashSet<VolumeOverrides> { default };
            var waiting = new Queue<VolumeOverrides>(met);
            while (waiting.Count > 0)
            {
                VolumeOverrides earlier = waiting.Dequeue();
                foreach (VolumeOverrides volume in each)
                {
                    VolumeOverrides both = volume.After(earlier);
                    if (met.Add(both)) waiting.Enqueue(both);
                }
            }
            return met;
        }

        private static ShadowOptions ChoicesOnly(in ShadowOptions options)
        {
            ShadowOptions choices = ShadowPresets.Options(QualityPreset.Custom);
            choices.technique = options.technique;
            choices.angularDiameterDegrees = options.angularDiameterDegrees > 0.0f ? AngularDiameter.SunDegrees : 0.0f;
            choices.mask = options.mask;
            choices.conservativeMask = options.conservativeMask;
            choices.halfResolution = options.halfResolution;
            choices.denoise = options.denoise;
            choices.contactShadowMetres = options.HasContactShadows ? OptionTable.ContactShadowMetres.Max : 0.0f;
            choices.farShadows = options.farShadows;
            choices.clouds = options.clouds;
            choices.accumulates = options.accumulates;
            return choices;
        }
    }
}
