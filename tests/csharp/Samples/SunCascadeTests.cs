using System;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// Compares the way from the engine's matrices to the library's scales with points worked out by hand.
    /// </summary>
    internal sealed class SunCascadeTests
    {
        // The light looks along +z from z = -10 to z = 30 onto a square of 16 m around (2, 3).
        private static SunCascade Cascade(int index, in AtlasLayout layout, bool reversed)
        {
            var cascade = new SunCascade
            {
                // Unity's view space looks along -z.
                view = new Matrix4x4(new Vector4(1, 0, 0, 0), new Vector4(0, 1, 0, 0), new Vector4(0, 0, -1, 0),
                                     new Vector4(-2, -3, -10, 1)),
                projection = new Matrix4x4(new Vector4(1 / 8.0f, 0, 0, 0), new Vector4(0, 1 / 8.0f, 0, 0),
                                           new Vector4(0, 0, -2 / 40.0f, 0), new Vector4(0, 0, -1, 1)),
            };
            cascade.Place(index, layout, 2.0f, reversed);
            return cascade;
        }

        private static Vector4 Shadow(in SunCascade cascade, float x, float y, float z) =>
            cascade.worldToShadow * new Vector4(x, y, z, 1.0f);

        private static void AssertNear(Vector4 actual, float x, float y, float z)
        {
            Assert.That(actual.x, Is.EqualTo(x).Within(1e-6f));
            Assert.That(actual.y, Is.EqualTo(y).Within(1e-6f));
            Assert.That(actual.z, Is.EqualTo(z).Within(1e-6f));
            Assert.That(actual.w, Is.EqualTo(1.0f));
        }

        [Test]
        public void CornersOfTheFrustumAreCornersOfTheTile([Values] bool reversed)
        {
            float near = reversed ? 1.0f : 0.0f;
            var layout = new AtlasLayout(2048, 4);
            SunCascade first = Cascade(0, layout, reversed);
            AssertNear(Shadow(first, -6.0f, -5.0f, -10.0f), 0.0f, 0.0f, near);
            AssertNear(Shadow(first, 10.0f, 11.0f, 30.0f), 0.5f, 0.5f, 1.0f - near);
            AssertNear(Shadow(Cascade(3, layout, reversed), 2.0f, 3.0f, 10.0f), 0.75f, 0.75f, 0.5f);
        }

        [Test]
        public void TwoCascadesShareALowMap()
        {
            var layout = new AtlasLayout(1024, 2);
            SunCascade second = Cascade(1, layout, true);
            AssertNear(Shadow(second, -6.0f, 11.0f, -10.0f), 0.5f, 1.0f, 1.0f);
            Assert.That(second.viewport, Is.EqualTo(new Rect(512.0f, 0.0f, 512.0f, 512.0f)));
        }

        [Test]
        public void ViewportsAreTheTilesInTexels()
        {
            var layout = new AtlasLayout(2048, 3);
            Assert.That(Cascade(0, layout, true).viewport, Is.EqualTo(new Rect(0.0f, 0.0f, 1024.0f, 1024.0f)));
            Assert.That(Cascade(2, layout, true).viewport, Is.EqualTo(new Rect(0.0f, 1024.0f, 1024.0f, 1024.0f)));
            Assert.That(Cascade(0, new AtlasLayout(2048, 1), true).viewport,
                        Is.EqualTo(new Rect(0.0f, 0.0f, 2048.0f, 2048.0f)));
        }

        [Test]
        public void ScalesAreThoseOfTheFrustumInEveryTile([Values(1, 2, 3, 4)] int count)
        {
            double depthToRadial = Math.Tan(Math.PI / 180.0) * (1.0 / 16.0) / (1.0 / 40.0);
            for (int i = 0; i < count; ++i)
            {
                Vector4 scales = Cascade(i, new AtlasLayout(2048, count), true).Scales;
                Assert.That(scales.x, Is.EqualTo(1.0 / 16.0).Within(1e-7));
                Assert.That(scales.y, Is.EqualTo(1.0 / 40.0).Within(1e-7));
                Assert.That(scales.z, Is.EqualTo(depthToRadial).Within(1e-6));
                Assert.That(scales.w, Is.EqualTo(1.0 / depthToRadial).Within(1e-4));
            }
        }

        [Test]
        public void ACascadeWithoutAMapHasAnEmptySphere()
        {
            SunCascade cascade = Cascade(0, new AtlasLayout(2048, 4), true);
            cascade.split.cullingSphere = new Vector4(1.0f, 2.0f, 3.0f, 4.0f);
            Assert.That(cascade.Sphere, Is.EqualTo(new Vector4(1.0f, 2.0f, 3.0f, 16.0f)));
            var none = new SunCascade { split = cascade.split };
            none.Place(0, new AtlasLayout(2048, 4), 2.0f, true);
            Assert.That(none.Sphere.w, Is.Zero);
        }
    }
}
