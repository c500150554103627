using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// Pairs of a pole and a block on both sides of a road, each pair a third farther away than the one before. The
    /// same shadow is drawn with larger and larger texels: where it changes abruptly, a cascade begins; where it
    /// stops, the shadow distance ends.
    /// </summary>
    internal static class CascadesScene
    {
        internal const float NearestMetres = 3.0f;
        internal const float FarthestMetres = 200.0f;
        internal const float Step = 4.0f / 3.0f;

        internal static SceneDescription Describe()
        {
            var scene = new SceneDescription
            {
                Sun = new SceneSun { elevationDegrees = 40.0f, azimuthDegrees = 70.0f },
                View = new SceneView
                {
                    position = new Vector3(0.0f, 2.5f, 0.0f),
                    eulerDegrees = new Vector3(5.0f, 0.0f, 0.0f),
                    fieldOfViewDegrees = 60.0f,
                },
            };
            scene.AddGround(new Vector3(0.0f, 0.0f, 0.5f * FarthestMetres), 120.0f, FarthestMetres + 40.0f);
            for (float distance = NearestMetres; distance <= FarthestMetres; distance *= Step)
            {
                // The spacing grows with the distance, so that no pair hides the next.
                float aside = 1.0f + 0.2f * distance;
                scene.AddStanding("Pole", PieceShape.Cylinder, new Vector3(-aside, 0.0f, distance),
                                  new Vector3(0.15f, 3.0f, 0.15f), SceneSurface.Metal);
                scene.AddStanding("Block", PieceShape.Box, new Vector3(aside, 0.0f, distance),
                                  new Vector3(1.0f, 2.0f, 1.0f), SceneSurface.Stone);
            }
            return scene;
        }
    }
}
