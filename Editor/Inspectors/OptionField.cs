using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>A field of ShadowOptions as inspectors show it, and under which options it has an effect.</summary>
    internal sealed class OptionField
    {
        /// <summary>In ShadowOptions, and in PenumbraShadowsVolume where that overrides it.</summary>
        internal readonly string name;

        internal readonly GUIContent label;

        private readonly Predicate<ShadowOptions> counts;
        private readonly Func<PenumbraShadowsVolume, VolumeParameter> parameter;

        /// <param name="parameter">What overrides it; null where a Volume cannot.</param>
        internal OptionField(string name, string label, string tooltip, Predicate<ShadowOptions> counts,
                             Func<PenumbraShadowsVolume, VolumeParameter> parameter)
        {
            this.name = name;
            this.label = new GUIContent(label, tooltip);
            this.counts = counts;
            this.parameter = parameter;
        }

        internal bool IsInVolume => parameter != null;

        /// <summary>Another value of it can change the picture.</summary>
        internal bool Counts(in ShadowOptions options) => counts(options);

        internal bool IsOverridden(PenumbraShadowsVolume volume) => IsInVolume && parameter(volume).overrideState;
    }
}
