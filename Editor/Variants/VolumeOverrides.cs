using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// The overrides of a Volume, or of several that overlap, that affect which program is used; null is not
    /// overridden. Numbers are omitted, as they would make the combinations endless; all that matters of them is
    /// whether the angular diameter and the length of contact shadows are 0.
    /// </summary>
    internal readonly struct VolumeOverrides : IEquatable<VolumeOverrides>
    {
        private readonly (QualityPreset? preset, bool? hasWidth, ShadowTechnique? technique, bool? mask,
            bool? conservativeMask, bool? halfResolution, bool? denoise, bool? contactShadows) values;

        private VolumeOverrides(
            (QualityPreset?, bool?, ShadowTechnique?, bool?, bool?, bool?, bool?, bool?) values) =>
            this.values = values;

        /// <summary>
        /// The overrides of `volume`: two variants for each number that it sets to 0, which is larger while the Volume
        /// fades in.
        /// </summary>
        internal static IEnumerable<VolumeOverrides> Of(PenumbraShadowsVolume volume)
        {
            foreach (bool? hasWidth in AboveZero(volume.angularDiameterDegrees))
                foreach (bool? hasContactShadows in AboveZero(volume.contactShadowMetres))
                    yield return Of(volume, hasWidth, hasContactShadows);
        }

        private static IEnumerable<bool?> AboveZero(VolumeParameter<float> parameter)
        {
            float? value = Value(parameter);
            yield return value.HasValue ? value > 0.0f : (bool?)null;
            if (value.HasValue && !(value > 0.0f)) yield return true;
        }

        private static VolumeOverrides Of(PenumbraShadowsVolume volume, bool? hasWidth, bool? hasContactShadows) =>
            new VolumeOverrides((Value(volume.preset), hasWidth, Value(volume.technique), Value(volume.mask),
                                 Value(volume.conservativeMask), Value(volume.halfResolution), Value(volume.denoise),
                                 hasContactShadows));

        /// <summary>Both overrides combined; this one has priority.</summary>
        internal VolumeOverrides After(in VolumeOverrides earlier) =>
            new VolumeOverrides((values.preset ?? earlier.values.preset, values.hasWidth ?? earlier.values.hasWidth,
                                 values.technique ?? earlier.values.technique, values.mask ?? earlier.values.mask,
                                 values.conservativeMask ?? earlier.values.conservativeMask,
                                 values.halfResolution ?? earlier.values.halfResolution,
                                 values.denoise ?? earlier.values.denoise,
                                 values.contactShadows ?? earlier.values.contactShadows));

        /// <summary>Sets these overrides, and no others, in the temporary Volume `stack`.</summary>
        internal void Fill(PenumbraShadowsVolume stack)
        {
            Set(stack.preset, values.preset);
            Set(stack.angularDiameterDegrees,
                values.hasWidth.HasValue ? (values.hasWidth.Value ? AngularDiameter.SunDegrees : 0.0f) : (float?)null);
            Set(stack.technique, values.technique);
            Set(stack.mask, values.mask);
            Set(stack.conservativeMask, values.conservativeMask);
            Set(stack.halfResolution, values.halfResolution);
            Set(stack.denoise, values.denoise);
            Set(stack.contactShadowMetres, values.contactShadows.HasValue
                                               ? (values.contactShadows.Value ? OptionTable.ContactShadowMetres.Max : 0.0f)
                                               : (float?)null);
        }

        private static T? Value<T>(VolumeParameter<T> parameter) where T : struct =>
            parameter.overrideState ? parameter.value : (T?)null;

        private static void Set<T>(VolumeParameter<T> parameter, T? value) where T : struct
        {
            parameter.overrideState = value.HasValue;
            if (value.HasValue) parameter.value = value.Value;
        }

        public bool Equals(VolumeOverrides other) => values.Equals(other.values);
        public override bool Equals(object other) => other is VolumeOverrides overrides && Equals(overrides);
        public override int GetHashCode() => values.GetHashCode();
    }
}
