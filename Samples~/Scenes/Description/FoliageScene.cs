using System.Collections.Generic;
using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// A grove: trees at random places, none within another's crown, each a trunk and a crown of small leaves. Under
    /// a crown nearly every pixel is in a penumbra, and every leaf has its own gap to the ground: the hardest case
    /// for PCSS.
    /// </summary>
    internal static class FoliageScene
    {
        internal const int Trees = 12;
        internal const float SmallestDistanceMetres = 4.0f;

        private const float GroveMetres = 44.0f;
        private const int LeavesOfACrown = 1500;

        // The placed trees exclude less than a third of the grove from the next one, so that most attempts succeed.
        private const int MostAttempts = 1000;

        internal static SceneDescription Describe(int seed)
        {
            var scene = new SceneDescription
            {
                Sun = new SceneSun { elevationDegrees = 55.0f, azimuthDegrees = 30.0f },
                View = new SceneView
                {
                    position = new Vector3(0.0f, 4.0f, -14.0f),
                    eulerDegrees = new Vector3(8.0f, 0.0f, 0.0f),
                    fieldOfViewDegrees = 60.0f,
                },
            };
            scene.AddGround(new Vector3(0.0f, 0.0f, 0.5f * GroveMetres), 80.0f, 80.0f);
            var chance = new SeededChance(seed);
            var places = new List<Vector3>();
            for (int attempt = 0; attempt < MostAttempts && places.Count < Trees; ++attempt)
            {
                var place = new Vector3(GroveMetres * (chance.Next() - 0.5f), 0.0f, GroveMetres * chance.Next());
                if (!IsFree(place, places)) continue;
                places.Add(place);
                AddTree(scene, place, chance);
            }
            return scene;
        }

        private static bool IsFree(Vector3 place, List<Vector3> places)
        {
            foreach (Vector3 other in places)
            {
                float x = place.x - other.x;
                float z = place.z - other.z;
                if (x * x + z * z < SmallestDistanceMetres * SmallestDistanceMetres) return false;
            }
            return true;
        }

        private static void AddTree(SceneDescription scene, Vector3 foot, SeededChance chance)
        {
            float trunk = 2.0f + 2.0f * chance.Next();
            float crown = 2.6f + 1.2f * chance.Next();
            float thickness = 0.18f + 0.12f * chance.Next();
            scene.AddStanding("Trunk", PieceShape.Cylinder, foot,
                              new Vector3(thickness, trunk + 0.4f * crown, thickness), SceneSurface.Bark);
            scene.Add(new ScenePiece
            {
                name = "Crown",
                mesh = LeafMesh.Describe(crown, LeavesOfACrown, chance),
                centre = new Vector3(foot.x, trunk + 0.5f * crown, foot.z),
                size = new Vector3(crown, crown, crown),
                surface = SceneSurface.Leaf,
            });
        }
    }
}
