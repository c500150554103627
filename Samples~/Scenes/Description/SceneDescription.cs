using System.Collections.Generic;
using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>The sun's direction: 90 degrees of elevation is straight above.</summary>
    internal struct SceneSun
    {
        internal float elevationDegrees;
        internal float azimuthDegrees;
    }

    /// <summary>The camera's position and direction: the angle x is down, y to the right of +z.</summary>
    internal struct SceneView
    {
        internal Vector3 position;
        internal Vector3 eulerDegrees;
        internal float fieldOfViewDegrees;
    }

    /// <summary>A scene as data, without engine objects. The same kind and seed give the same data.</summary>
    internal sealed class SceneDescription
    {
        private readonly List<ScenePiece> pieces = new List<ScenePiece>();

        internal IReadOnlyList<ScenePiece> Pieces => pieces;
        internal SceneSun Sun { get; set; }
        internal SceneView View { get; set; }

        internal static SceneDescription Of(SampleSceneKind kind, int seed)
        {
            switch (kind)
            {
                case SampleSceneKind.Fence: return FenceScene.Describe();
                case SampleSceneKind.Foliage: return FoliageScene.Describe(seed);
                case SampleSceneKind.Cascades: return CascadesScene.Describe();
                default: return ContactScene.Describe();
            }
        }

        internal void Add(ScenePiece piece) => pieces.Add(piece);

        /// <summary>A box as the ground: its upper side is at y = 0.</summary>
        internal void AddGround(Vector3 centre, float width, float depth)
        {
            const float thickness = 0.2f;
            pieces.Add(new ScenePiece
            {
                name = "Ground",
                shape = PieceShape.Box,
                centre = new Vector3(centre.x, -0.5f * thickness, centre.z),
                size = new Vector3(width, thickness, depth),
                surface = SceneSurface.Ground,
            });
        }

        /// <summary>A piece whose lowest point is `foot` if it is not rotated.</summary>
        internal void AddStanding(string name, PieceShape shape, Vector3 foot, Vector3 size, SceneSurface surface)
        {
            pieces.Add(new ScenePiece
            {
                name = name,
                shape = shape,
                centre = new Vector3(foot.x, foot.y + 0.5f * size.y, foot.z),
                size = size,
                surface = surface,
            });
        }
    }
}
