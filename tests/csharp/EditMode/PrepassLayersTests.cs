using NUnit.Framework;
using Penumbra.Editor;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Tests
{
    public sealed class PrepassLayersTests
    {
        private const int Water = 1 << 4;

        private static SerializedObject Renderer() =>
            new SerializedObject(ScriptableObject.CreateInstance<UniversalRendererData>());

        [Test]
        public void ANewRendererLeavesNothingOut() => Assert.That(PrepassLayers.LeftOut(Renderer()), Is.Zero);

        [Test]
        public void LayersAreNamed()
        {
            Assert.That(PrepassLayers.Names(Water), Is.EqualTo("Water"));
            Assert.That(PrepassLayers.Names(Water | (1 << 31) | (1 << 30)), Is.EqualTo("Water, layer 30, layer 31"));
            Assert.That(PrepassLayers.Explanation(Water), Does.Contain("(Water)"));
        }

#if UNITY_6000_3_OR_NEWER
        [Test]
        public void OpaqueLayersOutsideThePrepassAreFoundAndAdded()
        {
            SerializedObject renderer = Renderer();
            renderer.FindProperty("m_PrepassLayerMask").intValue = ~Water & ~1;
            renderer.FindProperty("m_OpaqueLayerMask").intValue = ~1;
            renderer.ApplyModifiedProperties();
            Assert.That(PrepassLayers.LeftOut(renderer), Is.EqualTo(Water));
            PrepassLayers.Add(renderer);
            Assert.That(PrepassLayers.LeftOut(renderer), Is.Zero);
            Assert.That(renderer.FindProperty("m_PrepassLayerMask").intValue, Is.EqualTo(~1));
        }

        private static UniversalRendererData Renderer(int prepass, bool active)
        {
            var renderer = ScriptableObject.CreateInstance<UniversalRendererData>();
            var serialized = new SerializedObject(renderer);
            serialized.FindProperty("m_PrepassLayerMask").intValue = prepass;
            serialized.ApplyModifiedProperties();
            for (int count = 0; count < 2; ++count)
            {
                var feature = ScriptableObject.CreateInstance<PenumbraShadows>();
                feature.SetActive(active);
                renderer.rendererFeatures.Add(feature);
            }
            return renderer;
        }

        [Test]
        public void OnlyRenderersWithAnActiveFeatureCountEachOnce()
        {
            UniversalRendererData leavesOut = Renderer(~Water, true);
            var renderers = new ScriptableRendererData[]
            {
                Renderer(-1, true), leavesOut, Renderer(~Water, false),
                ScriptableObject.CreateInstance<UniversalRendererData>(),
            };
            Assert.That(PrepassLayers.In(renderers), Is.EqualTo(new[] { ((ScriptableRendererData)leavesOut, Water) }));
        }
#endif
    }
}
