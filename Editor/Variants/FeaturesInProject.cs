using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>The active features of the project's renderers, and its Volume profiles that override them.</summary>
    internal static class FeaturesInProject
    {
        internal static bool Any
        {
            get
            {
                foreach (PenumbraShadowsSettings _ in Settings()) return true;
                return false;
            }
        }

        internal static ChainPrograms Programs() => ChainPrograms.Of(Settings(), Volumes());

        internal static List<ScriptableRendererData> Renderers() =>
            new List<ScriptableRendererData>(Assets<ScriptableRendererData>());

        /// <summary>The renderers that have an active feature.</summary>
        internal static IEnumerable<ScriptableRendererData> WithFeature(IEnumerable<ScriptableRendererData> renderers)
        {
            foreach (ScriptableRendererData renderer in renderers)
                foreach (PenumbraShadows _ in Features(new[] { renderer }))
                {
                    yield return renderer;
                    break;
                }
        }

        /// <summary>The active features of the project.</summary>
        internal static IEnumerable<PenumbraShadows> Features() => Features(Assets<ScriptableRendererData>());

        /// <summary>Whether a renderer of the project may draw a G-buffer.</summary>
        internal static bool AnyDeferred
        {
            get
            {
                foreach (ScriptableRendererData renderer in Assets<ScriptableRendererData>())
                    if (FeatureSurroundings.IsDeferred(renderer)) return true;
                return false;
            }
        }

        private static IEnumerable<PenumbraShadowsSettings> Settings() => Settings(Assets<ScriptableRendererData>());

        /// <summary>The settings of the active features of `renderers`.</summary>
        internal static IEnumerable<PenumbraShadowsSettings> Settings(IEnumerable<ScriptableRendererData> renderers)
        {
            foreach (PenumbraShadows feature in Features(renderers)) yield return feature.Settings;
        }

        private static IEnumerable<PenumbraShadows> Features(IEnumerable<ScriptableRendererData> renderers)
        {
            foreach (ScriptableRendererData renderer in renderers)
                foreach (ScriptableRendererFeature feature in renderer.rendererFeatures)
                    if (feature is PenumbraShadows shadows && shadows.isActive) yield return shadows;
        }

        private static List<PenumbraShadowsVolume> Volumes()
        {
            var found = new List<PenumbraShadowsVolume>();
            foreach (VolumeProfile profile in Assets<VolumeProfile>())
                if (profile.TryGet(out PenumbraShadowsVolume volume)) found.Add(volume);
            return found;
        }

        private static IEnumerable<T> Assets<T>() where T : Object
        {
            foreach (string guid in AssetDatabase.FindAssets("t:" + typeof(T).Name))
            {
                T asset = AssetDatabase.LoadAssetAtPath<T>(AssetDatabase.GUIDToAssetPath(guid));
                if (asset != null) yield return asset;
            }
        }
    }
}
