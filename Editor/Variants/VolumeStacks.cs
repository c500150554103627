using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// What a feature's options can come to under a project's Volumes. Where Volumes meet, each parameter has the value
    /// of the last one that overrides it; which one is the last their places and priorities decide, so every order
    /// counts. Unity passes a switch or a choice on from the moment a Volume fades in.
    /// </summary>
    internal static class VolumeStacks
    {
        /// <summary>Each once, the feature's own among them; numbers that choose no program are a preset's.</summary>
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

        // No Volume, one, and every one after whatever was there before.
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
            choices.halfResolution = options.halfResolution;
            choices.denoise = options.denoise;
            return choices;
        }
    }
}
