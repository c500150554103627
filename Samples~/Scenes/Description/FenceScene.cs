using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// A picket fence, a lattice of thin wires, and poles from half a metre to eight metres high. Biases remove bars
    /// that are thinner than a few texels of the shadow map, and blocker searches miss them; the shadows of the tall
    /// poles' tops vanish under a wide light.
    /// </summary>
    internal static class FenceScene
    {
        internal const int Pickets = 25;
        internal static readonly float[] PoleHeights = { 0.5f, 1.0f, 2.0f, 4.0f, 8.0f };

        private const float Spacing = 0.3f;
        private const float PicketHeight = 1.2f;

        internal static SceneDescription Describe()
        {
            var scene = new SceneDescription
            {
                Sun = new SceneSun { elevationDegrees = 35.0f, azimuthDegrees = 160.0f },
                View = new SceneView
                {
                    position = new Vector3(0.0f, 3.0f, -9.0f),
                    eulerDegrees = new Vector3(12.0f, 0.0f, 0.0f),
                    fieldOfViewDegrees = 60.0f,
                },
            };
            scene.AddGround(Vector3.zero, 40.0f, 40.0f);
            AddPickets(scene);
            AddLattice(scene);
            for (int i = 0; i < PoleHeights.Length; ++i)
                scene.AddStanding("Pole", PieceShape.Cylinder, new Vector3(-6.0f + 3.0f * i, 0.0f, 6.0f),
                                  new Vector3(0.08f, PoleHeights[i], 0.08f), SceneSurface.Metal);
            return scene;
        }

        private static void AddLattice(SceneDescription scene)
        {
            var lattice = new LatticeMesh.Size
            {
                widthMetres = 8.0f,
                heightMetres = 2.0f,
                spacingMetres = 0.2f,
                wireRadiusMetres = 0.004f,
            };
            // The lattice hangs a little above the ground, so that the frame does not reach into it.
            scene.Add(new ScenePiece
            {
                name = "Lattice",
                mesh = LatticeMesh.Describe(lattice),
                centre = new Vector3(0.0f, 0.02f + 0.5f * lattice.heightMetres, 3.0f),
                size = new Vector3(lattice.widthMetres, lattice.heightMetres, 2.0f * lattice.wireRadiusMetres),
                surface = SceneSurface.Metal,
            });
        }

        private static void AddPickets(SceneDescription scene)
        {
            float width = Spacing * (Pickets - 1);
            for (int i = 0; i < Pickets; ++i)
                scene.AddStanding("Picket", PieceShape.Box, new Vector3(-0.5f * width + Spacing * i, 0.0f, 0.0f),
                                  new Vector3(0.05f, PicketHeight, 0.03f), SceneSurface.Bark);
            foreach (float height in new[] { 0.25f, 0.95f })
                scene.AddStanding("Rail", PieceShape.Box, new Vector3(0.0f, height, 0.03f),
                                  new Vector3(width + 0.2f, 0.06f, 0.03f), SceneSurface.Bark);
        }
    }
}
