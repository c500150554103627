using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// Renderers of later URP 17 have a layer mask for the prepass beside that for opaque objects. What lies in an opaque
    /// layer outside of it is in no depth texture, and takes the shadow of what is behind it.
    /// </summary>
    internal static class PrepassLayers
    {
        // Serialized names: the mask is in URP 17.3 and 17.5, and not in 17.0.
        private const string Prepass = "m_PrepassLayerMask";
        private const string Opaque = "m_OpaqueLayerMask";

        /// <summary>Bits of the layers; 0 where the renderer draws the depth of all that is opaque.</summary>
        internal static int LeftOut(SerializedObject renderer)
        {
            SerializedProperty prepass = renderer.FindProperty(Prepass);
            SerializedProperty opaque = renderer.FindProperty(Opaque);
            return prepass == null || opaque == null ? 0 : opaque.intValue & ~prepass.intValue;
        }

        /// <summary>The renderers with an active feature that leave layers out, with the layers.</summary>
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

        /// <summary>Adds them to the prepass.</summary>
        internal static void Add(SerializedObject renderer)
        {
            renderer.FindProperty(Prepass).intValue |= LeftOut(renderer);
            renderer.ApplyModifiedProperties();
        }

        /// <summary>As the editor lists them; layers without a name by their number.</summary>
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
            "Prepass Layer Mask leaves opaque layers out (" + Names(layers) + "): surfaces in them take the main light's " +
            "shadow of what lies behind them.";
    }
}
