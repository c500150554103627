using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Preset first, its cost and error beside it; single options only where they count.</summary>
    [CustomEditor(typeof(PenumbraShadows))]
    internal sealed class PenumbraShadowsEditor : UnityEditor.Editor
    {
        private static readonly GUIContent NoiseLabel =
            new GUIContent("Noise", "Moving noise is for temporal antialiasing or an upscaler that averages frames.");

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            SerializedProperty settings = serializedObject.FindProperty("settings");
            SerializedProperty preset = settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.preset));
            EditorGUILayout.PropertyField(preset, OptionFields.Preset);
            if ((QualityPreset)preset.intValue == QualityPreset.Custom)
                ShowOptions(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.custom)));
            else
                ShowPreset(settings, (QualityPreset)preset.intValue);
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.noise)),
                                          NoiseLabel);
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.sceneView)));
            EditorGUILayout.PropertyField(
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.reflectionProbes)));
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.debugView)),
                                          OptionFields.DebugView.label);
            serializedObject.ApplyModifiedProperties();

            foreach (Advice advice in FeatureAdvice.For(FeatureSurroundings.Of((PenumbraShadows)target)))
                EditorGUILayout.HelpBox(advice.text, advice.type);
        }

        private void ShowOptions(SerializedProperty custom)
        {
            ShadowOptions options = ((PenumbraShadows)target).Settings.custom;
            foreach (OptionField option in OptionFields.All)
                if (option.Counts(options))
                    EditorGUILayout.PropertyField(custom.FindPropertyRelative(option.name), option.label);
        }

        private static void ShowPreset(SerializedProperty settings, QualityPreset preset)
        {
            SerializedProperty angle =
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.angularDiameterDegrees));
            EditorGUILayout.PropertyField(angle, OptionFields.AngularDiameter.label);
            EditorGUILayout.HelpBox(PresetText.Describe(ShadowPresets.Options(preset)) + "\n" +
                                    PresetText.Figures(preset, angle.floatValue), MessageType.None);
        }
    }
}
