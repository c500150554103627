using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Samples.Scenes
{
    /// <summary>Builds the scenes of game objects, which are the declarations' own simple ones.</summary>
    internal sealed class SampleSceneTests
    {
        private const string Lit = "Universal Render Pipeline/Lit";

        private SampleScene scene;

        [SetUp]
        public void SetUp()
        {
            Shader.Known[Lit] = new Shader();
            scene = new GameObject("root").AddComponent<SampleScene>();
        }

        [TearDown]
        public void TearDown() => Shader.Known.Remove(Lit);

        private T[] Made<T>() => scene.Built.OfType<T>().ToArray();

        [Test]
        public void EveryPieceTheSunAndTheCameraAreMadeBelowTheScene([Values] SampleSceneKind kind)
        {
            scene.Kind = kind;
            scene.Build();
            int pieces = SceneDescription.Of(kind, scene.Seed).Pieces.Count;
            Assert.That(Made<GameObject>().Length, Is.EqualTo(pieces + 2));
            Assert.That(Made<GameObject>().Select(item => item.transform.Above), Has.All.SameAs(scene.transform));
            Assert.That(Made<GameObject>().Count(item => item.GetComponent<Light>() != null), Is.EqualTo(1));
            Assert.That(Made<GameObject>().Count(item => item.GetComponent<Camera>() != null), Is.EqualTo(1));
            Assert.That(Made<GameObject>().Count(item => item.GetComponent<MeshRenderer>()?.sharedMaterial != null),
                        Is.EqualTo(pieces));
        }

        [Test]
        public void RemovingLeavesNothingAndBuildingTwiceNoMoreThanOnce([Values] bool playing)
        {
            Application.isPlaying = playing;
            scene.Kind = SampleSceneKind.Foliage;
            scene.Build();
            UnityEngine.Object[] first = scene.Built.ToArray();
            scene.Build();
            Assert.That(scene.Built.Count, Is.EqualTo(first.Length));
            Assert.That(first.Select(item => item.Destroyed), Has.All.True);
            UnityEngine.Object[] second = scene.Built.ToArray();
            scene.Remove();
            Assert.That(scene.Built, Is.Empty);
            Assert.That(second.Select(item => item.Destroyed), Has.All.True);
            Application.isPlaying = false;
        }

        [Test]
        public void OneMaterialServesAllPiecesOfASurface()
        {
            scene.Kind = SampleSceneKind.Foliage;
            scene.Build();
            Assert.That(Made<Material>().Select(material => material.name),
                        Is.EquivalentTo(new[] { "Penumbra Ground", "Penumbra Bark", "Penumbra Leaf" }));
        }

        [Test]
        public void TheSunIsTheScenesAndHasNoNormalBias()
        {
            scene.Build();
            Light sun = Made<GameObject>().Select(item => item.GetComponent<Light>()).Single(light => light != null);
            Assert.That(RenderSettings.sun, Is.SameAs(sun));
            Assert.That(sun.type, Is.EqualTo(LightType.Directional));
            Assert.That(sun.shadows, Is.EqualTo(LightShadows.Soft));
            Assert.That(sun.shadowNormalBias, Is.Zero);
            Assert.That(sun.gameObject.GetComponent<UniversalAdditionalLightData>().usePipelineSettings, Is.False);
        }

        [Test]
        public void ACylinderIsAsHighAsItsPieceThoughUnitysIsTwoMetres()
        {
            scene.Kind = SampleSceneKind.Fence;
            scene.Build();
            var poles = Made<GameObject>().Where(item => item.name == "Pole");
            Assert.That(poles.Select(pole => 2.0f * pole.transform.localScale.y), Is.EqualTo(FenceScene.PoleHeights));
        }

        [Test]
        public void WithoutUrpItSaysSo()
        {
            Shader.Known.Remove(Lit);
            var failure = Assert.Throws<InvalidOperationException>(() => scene.Build());
            Assert.That(failure.Message, Does.Contain("Universal Render Pipeline/Lit").And.Contain("URP"));
            scene.Remove();
            Assert.That(scene.Built, Is.Empty);
        }
    }
}
