using System.Globalization;
using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// A row of equal slabs, each higher above the ground than the one before, and objects that touch it: a wall, a
    /// ball, a leaning board. A penumbra is as wide as the gap times the light's angular diameter: zero at a contact,
    /// wide at the end of the row.
    /// </summary>
    internal static class ContactScene
    {
        /// <summary>Gap under each slab of the row, metres.</summary>
        internal static readonly float[] Gaps = { 0.0f, 0.05f, 0.25f, 0.5f, 1.0f, 2.0f, 4.0f };

        private const float Spacing = 2.0f;

        internal static SceneDescription Describe()
        {
            var scene = new SceneDescription
            {
                Sun = new SceneSun { elevationDegrees = 50.0f, azimuthDegrees = -35.0f },
                View = new SceneView
                {
                    position = new Vector3(0.0f, 5.0f, -11.0f),
                    eulerDegrees = new Vector3(20.0f, 0.0f, 0.0f),
                    fieldOfViewDegrees = 60.0f,
                },
            };
            scene.AddGround(Vector3.zero, 40.0f, 30.0f);
            float start = -0.5f * Spacing * (Gaps.Length - 1);
            for (int i = 0; i < Gaps.Length; ++i)
            {
                string name = string.Format(CultureInfo.InvariantCulture, "Slab {0:0.00} m", Gaps[i]);
                scene.AddStanding(name, PieceShape.Box, new Vector3(start + Spacing * i, Gaps[i], 0.0f),
                                  new Vector3(1.2f, 0.2f, 1.2f), SceneSurface.Stone);
            }
            scene.AddStanding("Wall", PieceShape.Box, new Vector3(0.0f, 0.0f, 6.0f), new Vector3(12.0f, 3.0f, 0.3f),
                              SceneSurface.Stone);
            scene.AddStanding("Ball", PieceShape.Ball, new Vector3(-4.0f, 0.0f, -3.0f), new Vector3(1.0f, 1.0f, 1.0f),
                              SceneSurface.Metal);
            scene.Add(Board());
            return scene;
        }

        // The board is a plank of 2.4 m whose lower edge touches the ground, leaning at 30 degrees to it.
        private static ScenePiece Board()
        {
            const float length = 2.4f;
            const float thickness = 0.06f;
            const float leanDegrees = 30.0f;
            float sine = Mathf.Sin(leanDegrees * Mathf.Deg2Rad);
            float cosine = Mathf.Cos(leanDegrees * Mathf.Deg2Rad);
            return new ScenePiece
            {
                name = "Leaning board",
                shape = PieceShape.Box,
                centre = new Vector3(4.0f, 0.5f * (length * sine + thickness * cosine), -3.0f),
                eulerDegrees = new Vector3(0.0f, 0.0f, leanDegrees),
                size = new Vector3(length, thickness, 0.8f),
                surface = SceneSurface.Bark,
            };
        }
    }
}
