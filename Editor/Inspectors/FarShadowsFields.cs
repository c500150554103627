using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>Selects the fields of FarShadowsSettings that have an effect.</summary>
    internal static class FarShadowsFields
    {
        internal static void Show(SerializedProperty settings)
        {
            SerializedProperty mode = settings.FindPropertyRelative(nameof(FarShadowsSettings.mode));
            SerializedProperty clouds = settings.FindPropertyRelative(nameof(FarShadowsSettings.clouds));
            EditorGUILayout.PropertyField(mode, OptionFields.FarShadows.label);
            EditorGUILayout.PropertyField(clouds, OptionFields.Clouds.label);
            SerializedProperty parameters = settings.FindPropertyRelative(nameof(FarShadowsSettings.parameters));
            foreach (string name in Parameters((FarShadowMode)mode.intValue, clouds.boolValue))
                EditorGUILayout.PropertyField(parameters.FindPropertyRelative(name));
            if (!clouds.boolValue) return;
            SerializedProperty layer = settings.FindPropertyRelative(nameof(FarShadowsSettings.cloudLayer));
            foreach (string name in CloudFields) EditorGUILayout.PropertyField(layer.FindPropertyRelative(name));
            EditorGUILayout.PropertyField(settings.FindPropertyRelative(nameof(FarShadowsSettings.windMetresPerSecond)));
        }

        /// <summary>The fields of FarShadowsParameters that count.</summary>
        internal static string[] Parameters(FarShadowMode mode, bool clouds)
        {
            if (mode == FarShadowMode.HeightMap)
                return new[]
                {
                    nameof(FarShadowsParameters.handOverBorder), nameof(FarShadowsParameters.heightSteps),
                    nameof(FarShadowsParameters.nearestMetres),
                };
            return mode == FarShadowMode.Off && !clouds ? new string[0]
                                                        : new[] { nameof(FarShadowsParameters.handOverBorder) };
        }

        internal static readonly string[] CloudFields =
        {
            nameof(CloudParameters.cloudAltitudeMetres), nameof(CloudParameters.cloudCoverage),
            nameof(CloudParameters.cloudDensity), nameof(CloudParameters.cloudFeatureMetres),
            nameof(CloudParameters.cloudMapMetres), nameof(CloudParameters.cloudBorder),
        };
    }
}
