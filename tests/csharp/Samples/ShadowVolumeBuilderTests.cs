using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples.ShadowVolumes
{
    /// <summary>The volumes are those of the program that measures them, vertex for vertex and triangle for triangle:
    /// tests/golden/shadow_volumes.json, which tests/scene/shadow_volume_test.cpp holds against its own.</summary>
    internal sealed class ShadowVolumeBuilderTests
    {
        private static IEnumerable<TestCaseData> Golden()
        {
            string file = Path.Combine(TestContext.CurrentContext.TestDirectory, "golden", "shadow_volumes.json");
            int number = 0;
            foreach (JsonElement item in JsonDocument.Parse(File.ReadAllText(file)).RootElement.GetProperty("cases")
                         .EnumerateArray())
                yield return new TestCaseData(item).SetArgDisplayNames(item.GetProperty("name") + " " + ++number);
        }

        private static float[] Numbers(JsonElement list) =>
            list.EnumerateArray().Select(item => (float)item.GetDouble()).ToArray();

        private static Vector3[] Places(JsonElement list)
        {
            float[] numbers = Numbers(list);
            return Enumerable.Range(0, numbers.Length / 3)
                .Select(i => new Vector3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2])).ToArray();
        }

        private static int[] Indices(JsonElement list) => list.EnumerateArray().Select(item => item.GetInt32()).ToArray();

        [TestCaseSource(nameof(Golden))]
        public void AVolumeIsTheOneThatIsMeasured(JsonElement item)
        {
            var built = new ShadowVolumeBuilder(Places(item.GetProperty("positions")),
                                                Indices(item.GetProperty("triangles")),
                                                Places(item.GetProperty("way"))[0]);
            Assert.That(built.Vertices, Is.EqualTo(Places(item.GetProperty("volumePositions"))));
            Assert.That(built.Triangles, Is.EqualTo(Indices(item.GetProperty("volumeTriangles"))));
            Assert.That(built.Triangles, Is.Not.Empty);
        }

        private static readonly Vector3 down = new Vector3(0.0f, -10.0f, 0.0f);

        private static readonly Vector3[] leaf =
        {
            new Vector3(0.0f, 0.0f, 0.0f), new Vector3(0.0f, 0.0f, 1.0f), new Vector3(1.0f, 0.0f, 0.0f),
        };

        [Test]
        public void WhatHasNoVolumeIsRefused()
        {
            var order = new[] { 0, 1, 2 };
            Assert.That(() => new ShadowVolumeBuilder(leaf, order, Vector3.zero), Throws.ArgumentException);
            Assert.That(() => new ShadowVolumeBuilder(leaf, order, new Vector3(0.0f, float.NaN, 0.0f)),
                        Throws.ArgumentException);
            Vector3[] broken = leaf.ToArray();
            broken[1].z = float.PositiveInfinity;
            Assert.That(() => new ShadowVolumeBuilder(broken, order, down),
                        Throws.ArgumentException.With.Message.Contains("vertex 1"));
            broken[1].z = 3.0e38f;
            Assert.That(() => new ShadowVolumeBuilder(broken, order, new Vector3(0.0f, -1.0f, 3.0e38f)),
                        Throws.ArgumentException.With.Message.Contains("range of a float"));
            Assert.That(new ShadowVolumeBuilder(leaf, new int[0], down).Triangles, Is.Empty);
        }

        private static Mesh LeafMesh()
        {
            var mesh = new Mesh { name = "Leaf" };
            mesh.SetVertices(leaf.ToList());
            mesh.SetTriangles(new List<int> { 0, 1, 2 }, 0);
            return mesh;
        }

        private static Light Sun()
        {
            Light sun = new GameObject("Sun").AddComponent<Light>();
            sun.transform.forward = new Vector3(0.0f, -1.0f, 0.0f);
            RenderSettings.sun = sun;
            return sun;
        }

        private static ShadowVolumeCaster Caster(Mesh mesh)
        {
            var item = new GameObject("Leaf");
            item.AddComponent<MeshFilter>().sharedMesh = mesh;
            ShadowVolumeCaster caster = item.AddComponent<ShadowVolumeCaster>();
            caster.Material = new Material(new Shader());
            return caster;
        }

        [TearDown]
        public void TearDown() { RenderSettings.sun = null; }

        [Test]
        public void ACasterBuildsAnewWhenTheSunTurnsOrItsScaleChanges()
        {
            Light sun = Sun();
            ShadowVolumeCaster caster = Caster(LeafMesh());
            caster.Refresh();
            Mesh first = caster.Volume;
            Assert.That(first.vertices.Min(at => at.y), Is.EqualTo(-100.0f));
            caster.Refresh();
            Assert.That(caster.Volume, Is.SameAs(first));
            caster.transform.localScale = new Vector3(1.0f, 2.0f, 1.0f);
            caster.Refresh();
            Assert.That(first.Destroyed);
            Assert.That(caster.Volume.vertices.Min(at => at.y), Is.EqualTo(-50.0f), "in the object's space");
            Mesh second = caster.Volume;
            sun.transform.forward = new Vector3(0.6f, -0.8f, 0.0f);
            caster.Refresh();
            Assert.That(second.Destroyed);
            RenderSettings.sun = null;
            Mesh third = caster.Volume;
            caster.Refresh();
            Assert.That(third.Destroyed);
            Assert.That(caster.Volume == null);
        }

        [Test]
        public void AMeshThatIsNotReadableIsNamed()
        {
            Sun();
            Mesh mesh = LeafMesh();
            mesh.Readable = false;
            var failure = Assert.Throws<InvalidOperationException>(() => Caster(mesh).Refresh());
            Assert.That(failure.Message, Does.Contain("\"Leaf\"").And.Contain("Read/Write"));
        }

        [Test]
        public void TheDarkeningTriangleCoversThePicture()
        {
            ShadowVolumeDarkening darkening = new GameObject("Darkening").AddComponent<ShadowVolumeDarkening>();
            darkening.Refresh();
            Assert.That(darkening.Triangle == null, "without a material");
            darkening.Material = new Material(new Shader());
            darkening.Refresh();
            Vector3[] corners = darkening.Triangle.vertices;
            foreach (float x in new[] { -1.0f, 1.0f })
                foreach (float y in new[] { -1.0f, 1.0f })
                {
                    float right = (x - corners[0].x) / (corners[2].x - corners[0].x);
                    float up = (y - corners[0].y) / (corners[1].y - corners[0].y);
                    Assert.That(right >= 0.0f && up >= 0.0f && right + up <= 1.0f);
                }
            Assert.That(darkening.Triangle.bounds.size.x, Is.GreaterThan(1.0e5f));
        }
    }

    /// <summary>Builds the scene of game objects, which are the declarations' own simple ones.</summary>
    internal sealed class ShadowVolumeSceneTests
    {
        private static readonly string[] shaders =
        {
            "Universal Render Pipeline/Lit", "Penumbra Samples/Shadow Volume Count",
            "Penumbra Samples/Shadow Volume Darken",
        };

        [SetUp]
        public void SetUp()
        {
            foreach (string name in shaders) Shader.Known[name] = new Shader();
        }

        [TearDown]
        public void TearDown()
        {
            foreach (string name in shaders) Shader.Known.Remove(name);
            RenderSettings.sun = null;
        }

        [Test]
        public void EveryThingAboveTheGroundHasAVolumeAndTheSunNoMap()
        {
            ShadowVolumeScene scene = new GameObject("root").AddComponent<ShadowVolumeScene>();
            scene.Build();
            GameObject[] items = scene.Built.OfType<GameObject>().ToArray();
            Assert.That(items.Where(item => item.GetComponent<MeshRenderer>() != null && item.name != "Ground")
                            .Select(item => item.GetComponent<ShadowVolumeCaster>()?.Material != null),
                        Is.All.True.And.Exactly(5).Items);
            Assert.That(items.Count(item => item.GetComponent<ShadowVolumeDarkening>()?.Material != null), Is.EqualTo(1));
            Assert.That(items.Count(item => item.GetComponent<Camera>() != null), Is.EqualTo(1));
            Assert.That(RenderSettings.sun.shadows, Is.EqualTo(LightShadows.None));
            UnityEngine.Object[] first = scene.Built.ToArray();
            scene.Build();
            Assert.That(first.Select(item => item.Destroyed), Is.All.True);
            scene.Remove();
            Assert.That(scene.Built, Is.Empty);
        }

        [Test]
        public void WithoutUrpOrTheSamplesShadersItSaysSo([ValueSource(nameof(shaders))] string missing)
        {
            Shader.Known.Remove(missing);
            ShadowVolumeScene scene = new GameObject("root").AddComponent<ShadowVolumeScene>();
            var failure = Assert.Throws<InvalidOperationException>(scene.Build);
            Assert.That(failure.Message, Does.Contain(missing));
            scene.Remove();
            Assert.That(scene.Built, Is.Empty);
        }
    }
}
