using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// Diagonal wires that cross at right angles, within an upright rectangle around the origin, and a frame.
    /// </summary>
    internal static class LatticeMesh
    {
        internal struct Size
        {
            internal float widthMetres;
            internal float heightMetres;

            /// <summary>Distance between wires along the ground.</summary>
            internal float spacingMetres;

            internal float wireRadiusMetres;
        }

        internal static SceneMesh Describe(in Size size)
        {
            var mesh = new SceneMesh("Lattice");
            int wires = (int)((size.widthMetres + size.heightMetres) / size.spacingMetres);
            for (int i = 1; i < wires; ++i)
            {
                AddAslant(mesh, size, i * size.spacingMetres - size.heightMetres, 1.0f);
                AddAslant(mesh, size, i * size.spacingMetres - size.heightMetres, -1.0f);
            }
            AddFrame(mesh, size);
            return mesh;
        }

        // Adds a wire at 45 degrees from `start` on the rectangle's lower edge or on its extension to the left, clipped
        // to the rectangle. It is mirrored for the other direction.
        private static void AddAslant(SceneMesh mesh, in Size size, float start, float mirror)
        {
            float from = Mathf.Max(start, 0.0f);
            float to = Mathf.Min(start + size.heightMetres, size.widthMetres);
            if (to - from < size.wireRadiusMetres) return;
            mesh.AddWire(Point(size, from, from - start, mirror), Point(size, to, to - start, mirror),
                         size.wireRadiusMetres);
        }

        private static void AddFrame(SceneMesh mesh, in Size size)
        {
            float radius = 2.0f * size.wireRadiusMetres;
            float width = size.widthMetres;
            float height = size.heightMetres;
            foreach (float y in new[] { 0.0f, height })
                mesh.AddWire(Point(size, 0.0f, y, 1.0f), Point(size, width, y, 1.0f), radius);
            foreach (float x in new[] { 0.0f, width })
                mesh.AddWire(Point(size, x, 0.0f, 1.0f), Point(size, x, height, 1.0f), radius);
        }

        private static Vector3 Point(in Size size, float x, float y, float mirror) =>
            new Vector3(mirror * (x - 0.5f * size.widthMetres), y - 0.5f * size.heightMetres, 0.0f);
    }
}
