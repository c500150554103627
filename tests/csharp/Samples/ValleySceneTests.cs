using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples.FarShadows
{
    /// <summary>Builds the valley of the declarations' own simple objects.</summary>
    internal sealed class ValleySceneTests
    {
        private static readonly string[] Shaders =
        {
            "Universal Render Pipeline/Terrain/Lit", "Universal Render Pipeline/Lit",
        };

        private ValleyScene scene;

        [SetUp]
        public void SetUp()
        {
            foreach (string shader in Shaders) Shader.Known[shader] = new Shader();
            scene = new GameObject("root").AddComponent<ValleyScene>();
        }

        [TearDown]
        public void TearDown()
        {
            foreach (string shader in Shaders) Shader.Known.Remove(shader);
        }

        private GameObject[] Objects => scene.Built.OfType<GameObject>().ToArray();

        private T The<T>() where T : Component =>
            Objects.Select(item => item.GetComponent<T>()).Single(component => component != null);

        [Test]
        public void TheTerrainIsTheGroundThatCastsFarShadows()
        {
            scene.Build();
            Terrain terrain = The<Terrain>();
            Assert.That(The<FarShadowGround>().Terrain, Is.SameAs(terrain));
            Assert.That(terrain.terrainData.heightmapResolution, Is.EqualTo(ValleyHeights.Samples));
            Assert.That(terrain.terrainData.Heights.GetLength(0), Is.EqualTo(ValleyHeights.Samples));
            Assert.That(terrain.terrainData.size.y, Is.EqualTo(ValleyHeights.TopMetres));
            Assert.That(terrain.materialTemplate, Is.Not.Null);
            Assert.That(terrain.gameObject.transform.Above, Is.SameAs(scene.transform));
        }

        // A row of heights has one z: SetHeights takes [z, x].
        [Test]
        public void HeightsAreThoseOfTheirPlaces()
        {
            float[,] heights = ValleyHeights.Sampled();
            Assert.That(heights.Cast<float>().Min(), Is.GreaterThan(0.0f));
            Assert.That(heights.Cast<float>().Max(), Is.LessThan(1.0f));
            float metre = ValleyHeights.SideMetres / (ValleyHeights.Samples - 1);
            Assert.That(heights[100, 400] * ValleyHeights.TopMetres,
                        Is.EqualTo(ValleyHeights.At(400 * metre - 2000.0f, 100 * metre - 2000.0f)).Within(1e-3f));
        }

        /// <summary>
        /// Without this the sample would show nothing: the ridge hides ground behind the shadow distance, and some is
        /// lit.
        /// </summary>
        [Test]
        public void TheRidgeShadowsGroundFarFromTheCamera()
        {
            scene.Build();
            Vector3 euler = The<Light>().gameObject.transform.localRotation.EulerDegrees;
            float rise = Mathf.Sin(euler.x * Mathf.Deg2Rad) / Mathf.Cos(euler.x * Mathf.Deg2Rad);
            Assert.That(euler.y, Is.EqualTo(270.0f), "it shines along -x");
            bool Hidden(float x, float z)
            {
                float from = ValleyHeights.At(x, z);
                for (float distance = 20.0f; x + distance < 2000.0f; distance += 5.0f)
                    if (ValleyHeights.At(x + distance, z) > from + rise * distance) return true;
                return false;
            }
            foreach (float z in new[] { -1300.0f, -800.0f, 0.0f, 1000.0f })
            {
                Assert.That(Hidden(0.0f, z), "the floor, at z = " + z);
                Assert.That(Enumerable.Range(0, 40).Any(step => !Hidden(-1200.0f + 20.0f * step, z)),
                            "the left slope below its top, at z = " + z);
            }
        }

        [Test]
        public void TreesStandOnTheGround()
        {
            scene.Build();
            GameObject[] trunks = Objects.Where(item => item.name == "Trunk").ToArray();
            Assert.That(trunks.Length, Is.GreaterThan(20));
            foreach (GameObject trunk in trunks)
            {
                Vector3 centre = trunk.transform.localPosition;
                float foot = centre.y - trunk.transform.localScale.y;  // a cylinder of Unity is two metres high
                Assert.That(foot, Is.LessThan(ValleyHeights.At(centre.x, centre.z)));
                Assert.That(foot, Is.GreaterThan(ValleyHeights.At(centre.x, centre.z) - 1.0f));
            }
        }

        [Test]
        public void BuildingTwiceLeavesNoMoreThanOnceAndRemovingNothing([Values] bool playing)
        {
            Application.isPlaying = playing;
            scene.Build();
            UnityEngine.Object[] first = scene.Built.ToArray();
            scene.Build();
            Assert.That(scene.Built.Count, Is.EqualTo(first.Length));
            Assert.That(first.Select(item => item.Destroyed), Has.All.True);
            scene.Remove();
            Assert.That(scene.Built, Is.Empty);
            Application.isPlaying = false;
        }

        [Test]
        public void WithoutUrpItSaysSo()
        {
            Shader.Known.Remove(Shaders[0]);
            var failure = Assert.Throws<InvalidOperationException>(() => scene.Build());
            Assert.That(failure.Message, Does.Contain(Shaders[0]).And.Contain("URP"));
            Assert.That(scene.Built, Is.Empty);
        }
    }
}
