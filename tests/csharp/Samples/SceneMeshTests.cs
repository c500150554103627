using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>Generated meshes are whole, wound as their normals say and as large as their piece says.</summary>
    internal sealed class SceneMeshTests
    {
        private static IEnumerable<TestCaseData> Meshes()
        {
            foreach (SampleSceneKind kind in Enum.GetValues(typeof(SampleSceneKind)))
                foreach (ScenePiece piece in SceneDescription.Of(kind, 3).Pieces.Where(piece => piece.mesh != null))
                    yield return new TestCaseData(piece).SetArgDisplayNames(kind + ", " + piece.name);
        }

        [TestCaseSource(nameof(Meshes))]
        public void EveryTriangleIsWoundAsItsNormalSays(object item)
        {
            SceneMesh mesh = ((ScenePiece)item).mesh;
            Assert.That(mesh.Triangles.Count % 3, Is.Zero);
            Assert.That(mesh.Triangles, Is.Not.Empty);
            Assert.That(Enumerable.Range(0, mesh.Triangles.Count / 3).Where(i => !IsWoundAsItsNormalSays(mesh, i)),
                        Is.Empty);
        }

        private static bool IsWoundAsItsNormalSays(SceneMesh mesh, int triangle)
        {
            int first = mesh.Triangles[3 * triangle];
            Vector3 a = mesh.Vertices[first];
            Vector3 face = Vector3.Cross(mesh.Vertices[mesh.Triangles[3 * triangle + 1]] - a,
                                         mesh.Vertices[mesh.Triangles[3 * triangle + 2]] - a);
            return Vector3.Dot(face, mesh.Normals[first]) > 0.0f;
        }

        [TestCaseSource(nameof(Meshes))]
        public void NormalsAreUnitVectorsOnePerVertexAndIndicesFitSixteenBits(object item)
        {
            SceneMesh mesh = ((ScenePiece)item).mesh;
            Assert.That(mesh.Normals.Count, Is.EqualTo(mesh.Vertices.Count));
            Assert.That(mesh.Vertices.Count, Is.LessThanOrEqualTo(SceneMesh.MostVertices));
            Assert.That(mesh.Triangles.Min(), Is.Zero);
            Assert.That(mesh.Triangles.Max(), Is.EqualTo(mesh.Vertices.Count - 1));
            Assert.That(mesh.Normals.Max(normal => Math.Abs(Vector3.Dot(normal, normal) - 1.0f)), Is.LessThan(1e-5f));
        }

        [TestCaseSource(nameof(Meshes))]
        public void VerticesFillTheSizeOfTheirPiece(object item)
        {
            var piece = (ScenePiece)item;
            // A wire of the frame is as thick as this beyond the rectangle it frames.
            const float slack = 0.01f;
            AssertFills(piece.mesh.Vertices.Select(v => v.x), piece.size.x, slack);
            AssertFills(piece.mesh.Vertices.Select(v => v.y), piece.size.y, slack);
        }

        private static void AssertFills(IEnumerable<float> along, float size, float slack)
        {
            Assert.That(along.Max(), Is.InRange(0.4f * size, 0.5f * size + slack));
            Assert.That(along.Min(), Is.InRange(-0.5f * size - slack, -0.4f * size));
        }

        [Test]
        public void AWireIsAsThickAndAsLongAsAsked([Values(0, 1, 2)] int axis)
        {
            float[] end = { 0.0f, 0.0f, 0.0f };
            end[axis] = 2.0f;
            var mesh = new SceneMesh("wire");
            mesh.AddWire(Vector3.zero, new Vector3(end[0], end[1], end[2]), 0.1f);
            Assert.That(mesh.Triangles.Count, Is.EqualTo(3 * 2 * 3));
            foreach (Vector3 vertex in mesh.Vertices)
            {
                float[] at = { vertex.x, vertex.y, vertex.z };
                float along = at[axis];
                at[axis] = 0.0f;
                Assert.That(along, Is.EqualTo(0.0f).Within(1e-6f).Or.EqualTo(2.0f).Within(1e-6f));
                Assert.That(at.Sum(x => x * x), Is.EqualTo(0.01f).Within(1e-6f));
            }
        }

        [Test]
        public void LatticeWiresStayWithinTheirFrame()
        {
            var size = new LatticeMesh.Size
            {
                widthMetres = 3.0f, heightMetres = 1.0f, spacingMetres = 0.25f, wireRadiusMetres = 0.002f,
            };
            SceneMesh mesh = LatticeMesh.Describe(size);
            Assert.That(mesh.Vertices.Max(v => Math.Abs(v.x)), Is.LessThanOrEqualTo(1.5f + 0.0041f));
            Assert.That(mesh.Vertices.Max(v => Math.Abs(v.y)), Is.LessThanOrEqualTo(0.5f + 0.0041f));
            // There are (3 + 1) / 0.25 places, without the two in the corners, both ways, and four bars; 12 vertices
            // each.
            Assert.That(mesh.Vertices.Count, Is.EqualTo((2 * 15 + 4) * 12));
        }

        [Test]
        public void LeavesAreSpreadEvenlyOverTheBall()
        {
            SceneMesh mesh = LeafMesh.Describe(4.0f, 4000, new SeededChance(5));
            float radius = 2.0f - LeafMesh.HalfLengthMetres;
            var centres = Enumerable.Range(0, 4000)
                                    .Select(i => (mesh.Vertices[4 * i] + mesh.Vertices[4 * i + 2]) * 0.5f).ToList();
            // Half the volume lies within this radius: the share is 0.5 with a deviation of 0.008.
            float half = radius * (float)Math.Pow(0.5, 1.0 / 3.0);
            Assert.That(centres.Count(c => Vector3.Dot(c, c) < half * half) / 4000.0, Is.EqualTo(0.5).Within(0.03));
            Assert.That(centres.Count(c => c.y > 0.0f) / 4000.0, Is.EqualTo(0.5).Within(0.03));
            Assert.That(centres.Count(c => c.x > c.z) / 4000.0, Is.EqualTo(0.5).Within(0.03));
            Assert.That(mesh.Vertices.Max(v => Vector3.Dot(v, v)), Is.LessThanOrEqualTo(2.0f * 2.0f));
        }

        [Test]
        public void ChanceIsEvenAndEachSeedHasItsOwn()
        {
            const int count = 20000;
            foreach (int seed in new[] { 0, 1, 2, int.MinValue })
            {
                var chance = new SeededChance(seed);
                var tenths = new int[10];
                for (int i = 0; i < count; ++i)
                {
                    // A number outside of [0, 1) would have no such place.
                    ++tenths[(int)Math.Floor(10.0f * chance.Next())];
                }
                // Each tenth has 2000, with a deviation of 42.
                Assert.That(tenths, Has.All.InRange(1800, 2200), "seed " + seed);
            }
            Assert.That(new SeededChance(1).Next(), Is.Not.EqualTo(new SeededChance(2).Next()));
        }
    }
}
