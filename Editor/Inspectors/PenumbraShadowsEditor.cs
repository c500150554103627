using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Preset first, its cost and error beside it; single options only where they count.</summary>
    [CustomEditor(typeof(PenumbraShadows))]
    internal sealed class PenumbraShadowsEditor : UnityEditor.Editor
    {
        private static readonly GUIContent PresetLabel = new GUIContent("Quality", "What a pixel may cost.");
        private static readonly GUIContent AngleLabel =
            new GUIContent("Angular Diameter", "Full angle of the light's disc in degrees; the sun's is 0.53.");
        private static readonly GUIContent NoiseLabel =
            new GUIContent("Noise", "Moving noise is for temporal antialiasing or an upscaler that averages frames.");

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            SerializedProperty settings = serializedObject.FindProperty("settings");
            SerializedProperty preset = settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.preset));
            EditorGUILayout.PropertyField(preset, PresetLabel);
            if ((QualityPreset)preset.intValue == QualityPreset.Custom)
                EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.custom)),
                                              true);
            else
                ShowPreset(settings, (QualityPreset)preset.intValue);
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.noise)),
                                          NoiseLabel);
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.sceneView)));
            EditorGUILayout.PropertyField(
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.reflectionProbes)));
            serializedObject.ApplyModifiedProperties();

            foreach (Advice advice in FeatureAdvice.For(FeatureSurroundings.Of((PenumbraShadows)target)))
                EditorGUILayout.HelpBox(advice.text, advice.type);
        }

        private static void ShowPreset(SerializedProperty settings, QualityPreset preset)
        {
            SerializedProperty angle =
                settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.angularDiameterDegrees));
            EditorGUILayout.PropertyField(angle, AngleLabel);
            EditorGUILayout.HelpBox(PresetText.Describe(ShadowPresets.Options(preset)) + "\n" +
                                    PresetText.Figures(preset, angle.floatValue), MessageType.None);
        }
    }
}
