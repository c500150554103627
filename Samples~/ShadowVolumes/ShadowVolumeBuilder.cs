using System;
using System.Collections.Generic;
using UnityEngine;

namespace Penumbra.Samples.ShadowVolumes
{
    /// <summary>
    /// The closed mesh around all that a mesh shades from a light in one direction (Crow 1977): a cap of the triangles
    /// that cast, the same cap moved along the light, and walls between their boundaries.
    /// <para>Vertices at one position are one vertex; triangles that share an edge are one piece. A piece is closed if
    /// every edge is passed as often in one direction as in the other. Of a closed piece the triangles cast that are
    /// turned away from the light, of any other every triangle. Walls stand where the directed edges of a cap do not
    /// cancel, so that the volume is closed whatever the mesh is. Triangles with two corners at one position, and those
    /// along which the light passes exactly, cast nothing.</para>
    /// </summary>
    internal sealed class ShadowVolumeBuilder
    {
        private struct Side
        {
            internal int low;
            internal int high;
            internal int triangle;
            internal int sign;
        }

        private readonly List<Vector3> welded = new List<Vector3>();
        private readonly List<int> triangles = new List<int>();
        private int[] above;
        private bool[] isOpen;

        /// <summary>
        /// The vertices of the cap on the mesh, then the same number of vertices moved along the light.
        /// </summary>
        internal readonly List<Vector3> Vertices = new List<Vector3>();

        /// <summary>
        /// Three indices for each triangle, clockwise as seen from outside of the volume, like Unity's.
        /// </summary>
        internal readonly List<int> Triangles = new List<int>();

        /// <summary>
        /// Builds the volume. `way` leads from a vertex to its place in the other cap, along the way the light travels.
        /// </summary>
        internal ShadowVolumeBuilder(IReadOnlyList<Vector3> positions, IReadOnlyList<int> indices, Vector3 way)
        {
            if (!IsFinite(way) || way.Equals(Vector3.zero))
                throw new ArgumentException("a shadow volume has a direction and a length", nameof(way));
            Weld(positions, indices);
            FindPieces();
            List<int> cap = CapTowards(way);
            KeepUsed(cap);
            AddMoved(way);
            AddTriangles(cap);
        }

        private static bool IsFinite(float number) => !float.IsNaN(number) && !float.IsInfinity(number);

        private static bool IsFinite(Vector3 vector) => IsFinite(vector.x) && IsFinite(vector.y) && IsFinite(vector.z);

        private void Weld(IReadOnlyList<Vector3> positions, IReadOnlyList<int> indices)
        {
            // Vector3's own Equals takes -0 for 0, its hash code does not.
            var at = new Dictionary<(float, float, float), int>();
            var corners = new int[3];
            for (int first = 0; first + 2 < indices.Count; first += 3)
            {
                for (int k = 0; k < 3; ++k)
                {
                    Vector3 position = positions[indices[first + k]];
                    if (!IsFinite(position))
                        throw new ArgumentException("vertex " + indices[first + k] + " is not finite",
                                                    nameof(positions));
                    var place = (position.x + 0.0f, position.y + 0.0f, position.z + 0.0f);
                    if (!at.TryGetValue(place, out corners[k]))
                    {
                        corners[k] = welded.Count;
                        at.Add(place, corners[k]);
                        welded.Add(new Vector3(place.Item1, place.Item2, place.Item3));
                    }
                }
                if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                    triangles.AddRange(corners);
            }
        }

        private static List<Side> SortedSides(List<int> triangles)
        {
            var sides = new List<Side>(triangles.Count);
            for (int i = 0; i < triangles.Count; ++i)
            {
                int from = triangles[i];
                int to = triangles[i % 3 == 2 ? i - 2 : i + 1];
                sides.Add(new Side { low = Math.Min(from, to), high = Math.Max(from, to), triangle = i / 3,
                                     sign = from < to ? 1 : -1 });
            }
            sides.Sort((a, b) => a.low != b.low ? a.low.CompareTo(b.low)
                               : a.high != b.high ? a.high.CompareTo(b.high) : a.triangle.CompareTo(b.triangle));
            return sides;
        }

        // The index behind the last side of the edge that begins at this one.
        private static int EndOfEdge(List<Side> sides, int begin, out int sumOfSigns)
        {
            int end = begin;
            sumOfSigns = 0;
            for (; end < sides.Count && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high; ++end)
                sumOfSigns += sides[end].sign;
            return end;
        }

        private int Top(int triangle)
        {
            while (above[triangle] != triangle)
            {
                above[triangle] = above[above[triangle]];
                triangle = above[triangle];
            }
            return triangle;
        }

        private void FindPieces()
        {
            above = new int[triangles.Count / 3];
            isOpen = new bool[above.Length];
            for (int i = 0; i < above.Length; ++i) above[i] = i;
            List<Side> sides = SortedSides(triangles);
            for (int begin = 0, end; begin < sides.Count; begin = end)
            {
                end = EndOfEdge(sides, begin, out _);
                for (int i = begin + 1; i < end; ++i) above[Top(sides[i].triangle)] = Top(sides[begin].triangle);
            }
            for (int begin = 0, end; begin < sides.Count; begin = end)
            {
                end = EndOfEdge(sides, begin, out int sum);
                if (sum != 0) isOpen[Top(sides[begin].triangle)] = true;
            }
        }

        // The product is computed in double, because the sign must not depend on the size of a triangle.
        private double AlongTheLight(int first, Vector3 way)
        {
            Vector3 a = welded[triangles[first]];
            Vector3 b = welded[triangles[first + 1]];
            Vector3 c = welded[triangles[first + 2]];
            double bx = (double)b.x - a.x, by = (double)b.y - a.y, bz = (double)b.z - a.z;
            double cx = (double)c.x - a.x, cy = (double)c.y - a.y, cz = (double)c.z - a.z;
            return (by * cz - cy * bz) * way.x + (bz * cx - cz * bx) * way.y + (bx * cy - cx * by) * way.z;
        }

        // The casting triangles, turned so that their fronts face the light.
        private List<int> CapTowards(Vector3 way)
        {
            var cap = new List<int>();
            for (int first = 0; first < triangles.Count; first += 3)
            {
                double along = AlongTheLight(first, way);
                if (along > 0.0)
                    cap.AddRange(new[] { triangles[first], triangles[first + 2], triangles[first + 1] });
                else if (along < 0.0 && isOpen[Top(first / 3)])
                    cap.AddRange(new[] { triangles[first], triangles[first + 1], triangles[first + 2] });
            }
            return cap;
        }

        private void KeepUsed(List<int> cap)
        {
            var kept = new Dictionary<int, int>();
            for (int i = 0; i < cap.Count; ++i)
            {
                if (!kept.TryGetValue(cap[i], out int vertex))
                {
                    vertex = Vertices.Count;
                    kept.Add(cap[i], vertex);
                    Vertices.Add(welded[cap[i]]);
                }
                cap[i] = vertex;
            }
        }

        private void AddMoved(Vector3 way)
        {
            int count = Vertices.Count;
            for (int i = 0; i < count; ++i)
            {
                Vector3 at = Vertices[i];
                var moved = new Vector3((float)((double)at.x + way.x), (float)((double)at.y + way.y),
                                        (float)((double)at.z + way.z));
                if (!IsFinite(moved))
                    throw new ArgumentException("a shadow volume that reaches beyond the range of a float", nameof(way));
                Vertices.Add(moved);
            }
        }

        private void AddTriangles(List<int> cap)
        {
            int moved = Vertices.Count / 2;
            Triangles.AddRange(cap);
            for (int first = 0; first < cap.Count; first += 3)
                Triangles.AddRange(new[] { moved + cap[first], moved + cap[first + 2], moved + cap[first + 1] });
            List<Side> sides = SortedSides(cap);
            for (int begin = 0, end; begin < sides.Count; begin = end)
            {
                end = EndOfEdge(sides, begin, out int sum);
                int from = sum > 0 ? sides[begin].low : sides[begin].high;
                int to = sum > 0 ? sides[begin].high : sides[begin].low;
                for (int wall = 0; wall < Math.Abs(sum); ++wall)
                    Triangles.AddRange(new[] { to, from, moved + from, to, moved + from, moved + to });
            }
        }
    }
}
