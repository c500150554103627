using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// Renderers of later URP 17 versions have separate layer masks for the prepass and for opaque objects. Surfaces
    /// in an opaque layer outside the prepass's mask are not in the depth texture, and receive the shadow of the
    /// surface behind them.
    /// </summary>
    internal static class PrepassLayers
    {
        // These are serialized names: the mask exists in URP 17.3 and 17.5, but not in 17.0.
        private const string Prepass = "m_PrepassLayerMask";
        private const string Opaque = "m_OpaqueLayerMask";

        /// <summary>Bit mask of the excluded layers; 0 if the prepass draws all opaque layers.</summary>
        internal static int LeftOut(SerializedObject renderer)
        {
            SerializedProperty prepass = renderer.FindProperty(Prepass);
            SerializedProperty opaque = renderer.FindProperty(Opaque);
            return prepass == null || opaque == null ? 0 : opaque.intValue & ~prepass.intValue;
        }

        /// <summary>The renderers with an active feature whose prepass excludes layers, with these layers.</summary>
        internal static List<(ScriptableRendererData renderer, int layers)> In(
            IEnumerable<ScriptableRendererData> renderers)
        {
            var found = new List<(ScriptableRendererData, int)>();
            foreach (ScriptableRendererData renderer in FeaturesInProject.WithFeature(renderers))
            {
                int layers = LeftOut(new SerializedObject(renderer));
                if (layers != 0) found.Add((renderer, layers));
            }
            return found;
        }

        /// <summary>Adds the excluded layers to the prepass.</summary>
        internal static void Add(SerializedObject renderer)
        {
            renderer.FindProperty(Prepass).intValue |= LeftOut(renderer);
            renderer.ApplyModifiedProperties();
        }

        /// <summary>The layers' names; layers without a name by number.</summary>
        internal static string Names(int layers)
        {
            var names = new List<string>();
            for (int layer = 0; layer < 32; ++layer)
            {
                if ((layers & (1 << layer)) == 0) continue;
                string name = LayerMask.LayerToName(layer);
                names.Add(string.IsNullOrEmpty(name) ? "layer " + layer : name);
            }
            return string.Join(", ", names);
        }

        internal static string Explanation(int layers) =>
            "Prepass Layer Mask excludes opaque layers (" + Names(layers) + "): surfaces in them receive the main " +
            "light's shadow of the surfaces behind them.";
    }
}
