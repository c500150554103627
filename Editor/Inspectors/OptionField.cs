using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>A field of ShadowOptions in inspectors, and the condition under which it has an effect.</summary>
    internal sealed class OptionField
    {
        /// <summary>The field's name in ShadowOptions, and in PenumbraShadowsVolume if that overrides it.</summary>
        internal readonly string name;

        internal readonly GUIContent label;

        private readonly Predicate<ShadowOptions> counts;
        private readonly Func<PenumbraShadowsVolume, VolumeParameter> parameter;

        /// <param name="parameter">The Volume parameter that overrides it; null if there is none.</param>
        internal OptionField(string name, string label, string tooltip, Predicate<ShadowOptions> counts,
                             Func<PenumbraShadowsVolume, VolumeParameter> parameter)
        {
            this.name = name;
            this.label = new GUIContent(label, tooltip);
            this.counts = counts;
            this.parameter = parameter;
        }

        internal bool IsInVolume => parameter != null;

        /// <summary>Whether the field has an effect with these options.</summary>
        internal bool Counts(in ShadowOptions options) => counts(options);

        internal bool IsOverridden(PenumbraShadowsVolume volume) => IsInVolume && parameter(volume).overrideState;
    }
}
