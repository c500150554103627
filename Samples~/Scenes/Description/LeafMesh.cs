using UnityEngine;

namespace Penumbra.Samples.Scenes
{
    /// <summary>
    /// A tree's crown: leaves distributed uniformly in a ball, with random orientations. A leaf is a rhombus of 18 by
    /// 9 centimetres with a two-sided material.
    /// </summary>
    internal static class LeafMesh
    {
        internal const float HalfLengthMetres = 0.09f;
        internal const float HalfWidthMetres = 0.045f;

        internal static SceneMesh Describe(float diameterMetres, int leaves, SeededChance chance)
        {
            var mesh = new SceneMesh("Leaves");
            // No leaf extends beyond the ball.
            float radius = 0.5f * diameterMetres - HalfLengthMetres;
            for (int i = 0; i < leaves; ++i)
            {
                // The fraction of a ball's volume within a radius grows with the radius cubed.
                Vector3 centre = Direction(chance) * (radius * Mathf.Pow(chance.Next(), 1.0f / 3.0f));
                Vector3 along = Direction(chance);
                Vector3 across = Across(along, chance);
                mesh.AddRhombus(centre, along * HalfLengthMetres, across * HalfWidthMetres);
            }
            return mesh;
        }

        // Directions are uniform over the sphere because all heights are equally likely (Archimedes).
        private static Vector3 Direction(SeededChance chance)
        {
            float height = 2.0f * chance.Next() - 1.0f;
            float angle = 2.0f * Mathf.PI * chance.Next();
            float ring = Mathf.Sqrt(Mathf.Max(1.0f - height * height, 0.0f));
            return new Vector3(ring * Mathf.Cos(angle), height, ring * Mathf.Sin(angle));
        }

        private static Vector3 Across(Vector3 along, SeededChance chance)
        {
            Vector3 across = Vector3.Cross(along, Direction(chance));
            // Two random directions are hardly ever parallel; if they are, another one is tried.
            return Vector3.Dot(across, across) > 1e-6f ? across.normalized : Across(along, chance);
        }
    }
}
