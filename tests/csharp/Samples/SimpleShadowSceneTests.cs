using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples.PlanarAndBlobShadows
{
    /// <summary>The scene without a shadow map, and the components that draw its shadows.</summary>
    internal sealed class SimpleShadowSceneTests
    {
        private static readonly string[] shaders =
        {
            "Universal Render Pipeline/Lit", PlanarShadow.ShaderName, BlobShadow.ShaderName,
        };

        private SimpleShadowScene scene;

        [SetUp]
        public void SetUp()
        {
            foreach (string name in shaders) Shader.Known[name] = new Shader();
            scene = new GameObject("root").AddComponent<SimpleShadowScene>();
        }

        [TearDown]
        public void TearDown()
        {
            foreach (string name in shaders) Shader.Known.Remove(name);
        }

        private T[] Made<T>() where T : Component =>
            scene.Built.OfType<GameObject>().Select(item => item.GetComponent<T>()).Where(item => item != null).ToArray();

        [Test]
        public void EachGapHasAShapeOfBothKindsAndNothingCastsIntoTheShadowMap()
        {
            scene.Build();
            Assert.That(Made<PlanarShadow>().Length, Is.EqualTo(SimpleShadowScene.Gaps.Length));
            Assert.That(Made<BlobShadow>().Length, Is.EqualTo(SimpleShadowScene.Gaps.Length));
            Assert.That(Made<Light>().Single().shadows, Is.EqualTo(LightShadows.None));
            Assert.That(Made<Camera>().Length, Is.EqualTo(1));
            Assert.That(Made<BlobShadow>().Select(blob => blob.gameObject.transform.localPosition.y - blob.RadiusMetres),
                        Is.EqualTo(SimpleShadowScene.Gaps).Within(1e-6f));
        }

        [Test]
        public void RemovingLeavesNothing()
        {
            scene.Build();
            Object[] first = scene.Built.ToArray();
            scene.Remove();
            Assert.That(scene.Built, Is.Empty);
            Assert.That(first.Select(item => item.Destroyed), Has.All.True);
        }

        [Test]
        public void APlanarShadowDrawsTheObjectsOwnMeshBelowItUntilItIsDisabled()
        {
            GameObject item = GameObject.CreatePrimitive(PrimitiveType.Cube);
            item.GetComponent<MeshFilter>().sharedMesh = new Mesh();
            PlanarShadow shadow = item.AddComponent<PlanarShadow>();
            shadow.OnEnable();
            ShadowCopy copy = shadow.Copy;
            Assert.That(copy.Item.transform.Above, Is.SameAs(item.transform));
            Assert.That(copy.Item.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(item.GetComponent<MeshFilter>().sharedMesh));
            Assert.That(copy.Item.GetComponent<MeshRenderer>().sharedMaterial.shader,
                        Is.SameAs(Shader.Known[PlanarShadow.ShaderName]));
            shadow.OnEnable();
            Assert.That(shadow.Copy, Is.SameAs(copy), "enabled twice");
            shadow.OnDisable();
            Assert.That(copy.Item.Destroyed && copy.Material.Destroyed);
            Assert.That(copy.Mesh.Destroyed, Is.False, "the object's own");
        }

        [Test]
        public void ABlobShadowTakesItsMeshWithIt()
        {
            BlobShadow shadow = new GameObject("ball").AddComponent<BlobShadow>();
            shadow.OnEnable();
            ShadowCopy copy = shadow.Copy;
            Assert.That(copy.Material.shader, Is.SameAs(Shader.Known[BlobShadow.ShaderName]));
            shadow.OnDisable();
            Assert.That(copy.Item.Destroyed && copy.Material.Destroyed && copy.Mesh.Destroyed);
        }

        [Test]
        public void WithoutItsShaderAShadowSaysSo()
        {
            Shader.Known.Remove(BlobShadow.ShaderName);
            Assert.That(() => new GameObject("ball").AddComponent<BlobShadow>().OnEnable(),
                        Throws.InvalidOperationException.With.Message.Contains("there is no shader \"" + BlobShadow.ShaderName));
        }
    }
}
