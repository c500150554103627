using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>The scenes as data are repeatable, stand on their ground and are in their camera's sight.</summary>
    internal sealed class SceneDescriptionTests
    {
        private static readonly SampleSceneKind[] kinds = (SampleSceneKind[])Enum.GetValues(typeof(SampleSceneKind));

        private static readonly int[] seeds = { 0, 1, -7, int.MaxValue, int.MinValue };

        private static IEnumerable<ScenePiece> Named(SceneDescription scene, string name) =>
            scene.Pieces.Where(piece => piece.name == name);

        [Test]
        public void TheSameSeedGivesTheSameScene([ValueSource(nameof(kinds))] SampleSceneKind kind,
                                                 [ValueSource(nameof(seeds))] int seed)
        {
            SceneDescription first = SceneDescription.Of(kind, seed);
            SceneDescription second = SceneDescription.Of(kind, seed);
            Assert.That(second.Pieces.Count, Is.EqualTo(first.Pieces.Count));
            for (int i = 0; i < first.Pieces.Count; ++i)
            {
                Assert.That(second.Pieces[i].centre, Is.EqualTo(first.Pieces[i].centre));
                Assert.That(second.Pieces[i].size, Is.EqualTo(first.Pieces[i].size));
                Assert.That(SameVertices(second.Pieces[i].mesh, first.Pieces[i].mesh));
            }
        }

        private static bool SameVertices(SceneMesh a, SceneMesh b) =>
            a == null ? b == null : b != null && a.Vertices.SequenceEqual(b.Vertices);

        [Test]
        public void AnotherSeedMovesTreesAndTurnsLeaves()
        {
            ScenePiece first = Named(FoliageScene.Describe(1), "Crown").First();
            ScenePiece second = Named(FoliageScene.Describe(2), "Crown").First();
            Assert.That(second.centre, Is.Not.EqualTo(first.centre));
            Assert.That(second.mesh.Normals[0], Is.Not.EqualTo(first.mesh.Normals[0]));
        }

        [Test]
        public void EverySceneHasOneGroundAndAllElseStandsOnIt([ValueSource(nameof(kinds))] SampleSceneKind kind)
        {
            SceneDescription scene = SceneDescription.Of(kind, 1);
            ScenePiece ground = Named(scene, "Ground").Single();
            Assert.That(ground.centre.y + 0.5f * ground.size.y, Is.EqualTo(0.0f).Within(1e-6f));
            foreach (ScenePiece piece in scene.Pieces.Where(piece => piece.name != "Ground"))
            {
                Assert.That(LowestPoint(piece), Is.GreaterThan(-1e-5f), piece.name);
                Assert.That(Math.Abs(piece.centre.x - ground.centre.x), Is.LessThan(0.5f * ground.size.x), piece.name);
                Assert.That(Math.Abs(piece.centre.z - ground.centre.z), Is.LessThan(0.5f * ground.size.z), piece.name);
            }
        }

        [Test]
        public void TheCameraSeesTheMiddleOfMostPieces([ValueSource(nameof(kinds))] SampleSceneKind kind)
        {
            SceneDescription scene = SceneDescription.Of(kind, 1);
            int seen = scene.Pieces.Count(piece => IsInSight(scene.View, piece.centre));
            Assert.That(seen, Is.GreaterThan(0.8 * scene.Pieces.Count));
        }

        [Test]
        public void TheSunStandsAboveTheHorizonAndNotInTheZenith([ValueSource(nameof(kinds))] SampleSceneKind kind) =>
            Assert.That(SceneDescription.Of(kind, 1).Sun.elevationDegrees, Is.InRange(20.0f, 70.0f));

        [Test]
        public void SlabsHoverAtTheirGaps()
        {
            List<ScenePiece> slabs =
                ContactScene.Describe().Pieces.Where(piece => piece.name.StartsWith("Slab")).ToList();
            Assert.That(slabs.Select(slab => LowestPoint(slab)), Is.EqualTo(ContactScene.Gaps).Within(1e-6f));
            Assert.That(slabs[2].name, Is.EqualTo("Slab 0.25 m"));
        }

        [Test]
        public void TheLeaningBoardTouchesTheGround()
        {
            ScenePiece board = Named(ContactScene.Describe(), "Leaning board").Single();
            Assert.That(LowestPoint(board), Is.EqualTo(0.0f).Within(1e-5f));
        }

        [Test]
        public void AFenceHasItsPicketsAndPoles()
        {
            SceneDescription scene = FenceScene.Describe();
            Assert.That(Named(scene, "Picket").Count(), Is.EqualTo(FenceScene.Pickets));
            Assert.That(Named(scene, "Pole").Select(pole => pole.size.y), Is.EqualTo(FenceScene.PoleHeights));
            Assert.That(Named(scene, "Rail").Count(), Is.EqualTo(2));
            Assert.That(Named(scene, "Lattice").Count(), Is.EqualTo(1));
        }

        [Test]
        public void EverySeedFindsPlacesForAllTreesApartFromEachOther()
        {
            for (int seed = -20; seed < 20; ++seed)
            {
                List<ScenePiece> trunks = Named(FoliageScene.Describe(seed), "Trunk").ToList();
                Assert.That(trunks.Count, Is.EqualTo(FoliageScene.Trees), "seed " + seed);
                IEnumerable<float> distances =
                    trunks.SelectMany((a, i) => trunks.Take(i).Select(b => Distance(a.centre, b.centre)));
                Assert.That(distances.Min(), Is.GreaterThanOrEqualTo(0.9999f * FoliageScene.SmallestDistanceMetres));
            }
        }

        [Test]
        public void ATrunkReachesIntoItsCrownAndNotThroughIt()
        {
            SceneDescription scene = FoliageScene.Describe(1);
            foreach ((ScenePiece trunk, ScenePiece crown) in Named(scene, "Trunk").Zip(Named(scene, "Crown")))
            {
                float top = trunk.centre.y + 0.5f * trunk.size.y;
                Assert.That(top, Is.InRange(crown.centre.y - 0.5f * crown.size.y, crown.centre.y));
                Assert.That(crown.centre.x, Is.EqualTo(trunk.centre.x));
            }
        }

        [Test]
        public void CascadesAreFilledFromNearToFarInEqualSteps()
        {
            List<float> distances = Named(CascadesScene.Describe(), "Block").Select(block => block.centre.z).ToList();
            Assert.That(distances[0], Is.EqualTo(CascadesScene.NearestMetres));
            Assert.That(distances.Last() * CascadesScene.Step, Is.GreaterThan(CascadesScene.FarthestMetres));
            Assert.That(distances.Last(), Is.LessThanOrEqualTo(CascadesScene.FarthestMetres));
            for (int i = 1; i < distances.Count; ++i)
                Assert.That(distances[i] / distances[i - 1], Is.EqualTo(CascadesScene.Step).Within(1e-4f));
        }

        private static float Distance(Vector3 a, Vector3 b) =>
            (float)Math.Sqrt((a.x - b.x) * (a.x - b.x) + (a.z - b.z) * (a.z - b.z));

        // No piece is turned about another axis than z.
        private static float LowestPoint(in ScenePiece piece)
        {
            Assert.That(piece.eulerDegrees.x, Is.Zero);
            double angle = piece.eulerDegrees.z * Math.PI / 180.0;
            return (float)(piece.centre.y - 0.5 * (Math.Abs(Math.Sin(angle)) * piece.size.x +
                                                   Math.Abs(Math.Cos(angle)) * piece.size.y));
        }

        // The picture has 16:9, and the camera's angles are defined as Unity's are: pitch is down, +z is ahead.
        private static bool IsInSight(in SceneView view, Vector3 point)
        {
            Assert.That(view.eulerDegrees.y, Is.Zero);
            double pitch = view.eulerDegrees.x * Math.PI / 180.0;
            double y = point.y - view.position.y;
            double z = point.z - view.position.z;
            double ahead = Math.Cos(pitch) * z - Math.Sin(pitch) * y;
            double above = Math.Sin(pitch) * z + Math.Cos(pitch) * y;
            double half = Math.Tan(view.fieldOfViewDegrees * Math.PI / 360.0);
            return ahead > 0.0 && Math.Abs(above) < half * ahead &&
                   Math.Abs(point.x - view.position.x) < half * ahead * 16.0 / 9.0;
        }
    }
}
