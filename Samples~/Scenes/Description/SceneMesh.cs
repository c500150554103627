using System.Collections.Generic;
using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// Triangles around the origin, metres. They are clockwise as seen from the side of the normals, like Unity's, and
    /// have fewer than 65536 vertices, so that 16-bit indices suffice.
    /// </summary>
    internal sealed class SceneMesh
    {
        internal const int MostVertices = 65535;

        private static readonly int[] quad = { 0, 1, 2, 0, 2, 3 };

        internal readonly List<Vector3> Vertices = new List<Vector3>();
        internal readonly List<Vector3> Normals = new List<Vector3>();
        internal readonly List<int> Triangles = new List<int>();

        internal SceneMesh(string name) { Name = name; }

        internal string Name { get; }

        /// <summary>A flat rhombus; a and b are its half diagonals.</summary>
        internal void AddRhombus(Vector3 centre, Vector3 a, Vector3 b) =>
            AddQuad(new[] { centre + a, centre + b, centre - a, centre - b }, Vector3.Cross(a, b).normalized);

        /// <summary>A wire: a three-sided prism from one point to another, open at its ends.</summary>
        internal void AddWire(Vector3 from, Vector3 to, float radius)
        {
            Vector3 along = (to - from).normalized;
            Vector3 other = Mathf.Abs(along.y) < 0.9f ? new Vector3(0.0f, 1.0f, 0.0f) : new Vector3(1.0f, 0.0f, 0.0f);
            Vector3 right = Vector3.Cross(along, other).normalized;
            Vector3 up = Vector3.Cross(right, along);
            Vector3 start = right * radius;
            for (int side = 1; side <= 3; ++side)
            {
                float angle = side * 2.0f * Mathf.PI / 3.0f;
                Vector3 end = right * (radius * Mathf.Cos(angle)) + up * (radius * Mathf.Sin(angle));
                AddQuad(new[] { from + start, to + start, to + end, from + end }, (start + end).normalized);
                start = end;
            }
        }

        private void AddQuad(Vector3[] corners, Vector3 normal)
        {
            int first = Vertices.Count;
            foreach (Vector3 corner in corners)
            {
                Vertices.Add(corner);
                Normals.Add(normal);
            }
            foreach (int corner in quad) Triangles.Add(first + corner);
        }
    }
}
