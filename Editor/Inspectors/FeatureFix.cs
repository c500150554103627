using System;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering.Universal;
using Object = UnityEngine.Object;

namespace Penumbra.Editor
{
    /// <summary>
    /// The Fix buttons of the feature's inspector. Each fix can be undone, and changes nothing but what its message
    /// names. A fix is null where there is nothing to fix, or where the project's author has to decide.
    /// </summary>
    internal struct FeatureFixes
    {
        internal Action mainLightShadows;
        internal Action lightShadows;
        internal Action lightBias;
        internal Action urpScreenSpaceShadows;
        internal Action prepassLayers;
        internal Action depthPriming;
        internal Action ground;
    }

    internal static class FeatureFix
    {
        private const string Name = "Fix for " + PenumbraShadows.Title;

        internal static void CastShadows(UniversalRenderPipelineAsset asset)
        {
            var serialized = new SerializedObject(asset);
            serialized.FindProperty("m_MainLightShadowsSupported").boolValue = true;
            serialized.ApplyModifiedProperties();
        }

        internal static void CastShadows(Light light) => Change(() => light.shadows = LightShadows.Soft, light);

        /// <summary>
        /// Sets a normal bias of 0 for this light alone: point and spot lights, which keep URP's filter, may need that
        /// of the asset.
        /// </summary>
        internal static void SetBias(Light light, float depth)
        {
            if (!light.TryGetComponent(out UniversalAdditionalLightData data))
                data = Undo.AddComponent<UniversalAdditionalLightData>(light.gameObject);
            Change(() =>
            {
                data.usePipelineSettings = false;
                light.shadowBias = depth;
                light.shadowNormalBias = 0.0f;
            }, light, data);
        }

        internal static void Deactivate(ScriptableRendererFeature feature) =>
            Change(() => feature.SetActive(false), feature);

        internal static void DisableDepthPriming(UniversalRendererData renderer) =>
            Change(() => renderer.depthPrimingMode = DepthPrimingMode.Disabled, renderer);

        /// <summary>
        /// The fix that adds the component where it belongs: to the only Terrain, if that has none, not even a disabled
        /// one. Null where it is not clear where it belongs.
        /// </summary>
        internal static Action AddGround()
        {
            Terrain[] terrains = Terrain.activeTerrains;
            if (terrains.Length != 1 || terrains[0].TryGetComponent(out FarShadowGround _)) return null;
            GameObject owner = terrains[0].gameObject;
            return () => Undo.AddComponent<FarShadowGround>(owner);
        }

        private static void Change(Action change, params Object[] targets)
        {
            Undo.RecordObjects(targets, Name);
            change();
            foreach (Object target in targets) PrefabUtility.RecordPrefabInstancePropertyModifications(target);
        }
    }
}
