using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>The primitive of a piece without a mesh of its own.</summary>
    internal enum PieceShape
    {
        Box,
        Cylinder,
        Ball,
    }

    /// <summary>The surface of a piece; there is one material for each.</summary>
    internal enum SceneSurface
    {
        Ground,
        Stone,
        Metal,
        Bark,
        Leaf,
    }

    /// <summary>
    /// One object of a scene. Lengths are metres, y is up, the ground is at y = 0; a piece is rotated about its
    /// centre.
    /// </summary>
    internal struct ScenePiece
    {
        internal string name;
        internal PieceShape shape;

        /// <summary>The piece's own mesh; null for a primitive of the shape.</summary>
        internal SceneMesh mesh;

        internal Vector3 centre;
        internal Vector3 eulerDegrees;

        /// <summary>Size of the whole piece before rotation. A mesh already has its size and is not scaled.</summary>
        internal Vector3 size;

        internal SceneSurface surface;
    }

    internal static class SceneSurfaces
    {
        /// <summary>
        /// The surface's colour in sRGB, as picked in an inspector. The ground is light, so that shadows are easy to
        /// judge.
        /// </summary>
        internal static Color Color(SceneSurface surface)
        {
            switch (surface)
            {
                case SceneSurface.Ground: return new Color(0.8f, 0.8f, 0.78f, 1.0f);
                case SceneSurface.Stone: return new Color(0.65f, 0.62f, 0.58f, 1.0f);
                case SceneSurface.Metal: return new Color(0.35f, 0.37f, 0.4f, 1.0f);
                case SceneSurface.Bark: return new Color(0.36f, 0.27f, 0.2f, 1.0f);
                default: return new Color(0.3f, 0.45f, 0.2f, 1.0f);
            }
        }
    }
}
