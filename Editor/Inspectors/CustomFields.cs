using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>
    /// Changes the options of the preset Custom. They are written through the serialized object, as in LookFields, so
    /// that one undo reverts both the choice of Custom and its values.
    /// </summary>
    internal static class CustomFields
    {
        /// <summary>
        /// If the preset of `edited` has just become Custom, its options become those used until then: the image
        /// stays the same, and the user changes one option of a preset instead of setting them all.
        /// </summary>
        /// <param name="edited">The feature's settings before they are applied.</param>
        /// <param name="inForce">The feature's current settings.</param>
        internal static void KeepPreset(SerializedProperty edited, PenumbraShadowsSettings inForce)
        {
            SerializedProperty preset = edited.FindPropertyRelative(nameof(PenumbraShadowsSettings.preset));
            if ((QualityPreset)preset.intValue != QualityPreset.Custom || inForce.preset == QualityPreset.Custom) return;
            Write(edited.FindPropertyRelative(nameof(PenumbraShadowsSettings.custom)), inForce.Options());
        }

        /// <summary>
        /// If the technique of Custom has just changed, its own options become those that it is measured with, as the
        /// same number means something else to another technique. The look stays.
        /// </summary>
        /// <param name="edited">The feature's settings before they are applied.</param>
        /// <param name="inForce">The feature's current settings.</param>
        internal static void BeginAsMeasured(SerializedProperty edited, PenumbraShadowsSettings inForce)
        {
            SerializedProperty custom = edited.FindPropertyRelative(nameof(PenumbraShadowsSettings.custom));
            var technique = (ShadowTechnique)custom.FindPropertyRelative(nameof(ShadowOptions.technique)).intValue;
            if (inForce.preset != QualityPreset.Custom || technique == inForce.custom.technique) return;
            ShadowOptions options = inForce.custom;
            options.technique = technique;
            technique.Entry().SetMeasured(ref options);
            options.softnessCapMetres = inForce.custom.softnessCapMetres;
            Write(custom, options);
        }

        private static void Write(SerializedProperty custom, in ShadowOptions options)
        {
            custom.FindPropertyRelative(nameof(options.technique)).intValue = (int)options.technique;
            custom.FindPropertyRelative(nameof(options.angularDiameterDegrees)).floatValue = options.angularDiameterDegrees;
            custom.FindPropertyRelative(nameof(options.blockerSamples)).intValue = options.blockerSamples;
            custom.FindPropertyRelative(nameof(options.filterSamples)).intValue = options.filterSamples;
            custom.FindPropertyRelative(nameof(options.softnessCapMetres)).floatValue = options.softnessCapMetres;
            custom.FindPropertyRelative(nameof(options.minFilterTexels)).floatValue = options.minFilterTexels;
            custom.FindPropertyRelative(nameof(options.lightBleeding)).floatValue = options.lightBleeding;
            custom.FindPropertyRelative(nameof(options.mapBlurTexels)).floatValue = options.mapBlurTexels;
            custom.FindPropertyRelative(nameof(options.mapFormat)).intValue = (int)options.mapFormat;
            custom.FindPropertyRelative(nameof(options.rays)).intValue = options.rays;
            custom.FindPropertyRelative(nameof(options.samplesPerRay)).intValue = options.samplesPerRay;
            custom.FindPropertyRelative(nameof(options.discRadiusMetres)).floatValue = options.discRadiusMetres;
            custom.FindPropertyRelative(nameof(options.mask)).boolValue = options.mask;
            custom.FindPropertyRelative(nameof(options.conservativeMask)).boolValue = options.conservativeMask;
            custom.FindPropertyRelative(nameof(options.halfResolution)).boolValue = options.halfResolution;
            custom.FindPropertyRelative(nameof(options.denoise)).boolValue = options.denoise;
        }
    }
}
