using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>
    /// Shows the preset with its cost and error, then the look, then the single options that have an effect.
    /// </summary>
    [CustomEditor(typeof(PenumbraShadows))]
    internal sealed class PenumbraShadowsEditor : UnityEditor.Editor
    {
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            SerializedProperty settings = serializedObject.FindProperty("settings");
            SerializedProperty preset = settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.preset));
            EditorGUILayout.PropertyField(preset, OptionFields.Preset);
            CustomFields.KeepPreset(settings, ((PenumbraShadows)target).Settings);
            if ((QualityPreset)preset.intValue == QualityPreset.Custom)
                ShowOptions(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.custom)));
            else ShowPreset(settings, (QualityPreset)preset.intValue);
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.noise)));
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.sceneView)));
            EditorGUILayout.PropertyField(
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.reflectionProbes)));
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.cascadeBlend)),
                                          OptionFields.CascadeBlend.label);
            SerializedProperty contact =
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.contactShadowMetres));
            EditorGUILayout.PropertyField(contact, OptionFields.ContactShadows.label);
            if (contact.floatValue > 0.0f)
                EditorGUILayout.PropertyField(
                    settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.contactShadowSteps)),
                    OptionFields.ContactShadowSteps.label);
            FarShadowsFields.Show(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.farShadows)));
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.debugView)),
                                          OptionFields.DebugView.label);
            CustomFields.BeginAsMeasured(settings, ((PenumbraShadows)target).Settings);
            serializedObject.ApplyModifiedProperties();

            AdviceBox.Show(FeatureAdvice.For(FeatureSurroundings.Of((PenumbraShadows)target)));
        }

        private void ShowOptions(SerializedProperty custom)
        {
            ShowLook(new LookFields(custom.FindPropertyRelative(OptionFields.AngularDiameter.name),
                                    custom.FindPropertyRelative(OptionFields.SoftnessCap.name)));
            ShadowOptions options = ((PenumbraShadows)target).Settings.custom;
            foreach (OptionField option in OptionFields.All)
                if (option.Counts(options))
                    EditorGUILayout.PropertyField(custom.FindPropertyRelative(option.name), option.label);
        }

        private static void ShowPreset(SerializedProperty settings, QualityPreset preset)
        {
            SerializedProperty angle =
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.angularDiameterDegrees));
            SerializedProperty cap = settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.softnessCapMetres));
            string figures = PresetText.Describe(ShadowPresets.Options(preset)) + "\n" +
                             PresetText.Figures(preset, angle.floatValue);
            string capped = LookText.OfFigures(cap.floatValue);
            EditorGUILayout.HelpBox(capped == null ? figures : figures + " " + capped, MessageType.None);
            ShowLook(new LookFields(angle, cap));
            EditorGUILayout.PropertyField(angle, OptionFields.AngularDiameter.label);
            EditorGUILayout.PropertyField(cap, OptionFields.SoftnessCap.label);
        }

        private static void ShowLook(LookFields fields)
        {
            ShadowLook look = fields.Look;
            var chosen = (ShadowLook)EditorGUILayout.Popup(LookText.Label, (int)look, LookText.Names);
            if (chosen != look && chosen != ShadowLook.Custom) fields.Look = chosen;
            string text = LookText.Describe(fields.Look);
            if (text != null) EditorGUILayout.HelpBox(text, MessageType.None);
        }
    }
}
