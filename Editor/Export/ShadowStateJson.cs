using System.Globalization;
using System.Text;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// Writes the input of `penumbra constants --matrices`, with numbers that are read back bit-exactly.
    /// </summary>
    internal static class ShadowStateJson
    {
        internal static string Write(in ShadowState state)
        {
            var text = new StringBuilder("{\n");
            text.Append("  \"matrix_order\": \"row-major\",\n  \"clip_depth\": \"minus_one_to_one\",\n");
            text.Append("  \"reversed_z\": ").Append(state.reversedZ ? "true" : "false").Append(",\n");
            Number(text, "angular_diameter_degrees", state.angularDiameterDegrees);
            text.Append("  \"resolution\": ").Append(state.resolution).Append(",\n");
            Number(text, "depth_bias", state.depthBias);
            Number(text, "normal_bias", state.normalBias);
            text.Append("  \"soft_quality\": \"").Append(state.softQuality).Append("\",\n");
            text.Append("  \"light_direction\": ");
            List(text, state.lightDirection.x, state.lightDirection.y, state.lightDirection.z);
            text.Append(",\n  \"cascades\": [\n");
            for (int i = 0; i < state.cascadeCount; ++i)
            {
                Cascade(text, state, i);
                text.Append(i + 1 < state.cascadeCount ? ",\n" : "\n");
            }
            return text.Append("  ]\n}\n").ToString();
        }

        private static void Cascade(StringBuilder text, in ShadowState state, int index)
        {
            Matrix4x4 m = state.worldToShadow[index];
            text.Append("    {\"world_to_shadow\": ");
            List(text, m.m00, m.m01, m.m02, m.m03, m.m10, m.m11, m.m12, m.m13, m.m20, m.m21, m.m22, m.m23, m.m30,
                 m.m31, m.m32, m.m33);
            if (state.splitSpheres != null && index < state.splitSpheres.Length)
            {
                Vector4 sphere = state.splitSpheres[index];
                text.Append(",\n     \"split_sphere\": ");
                List(text, sphere.x, sphere.y, sphere.z, Mathf.Sqrt(sphere.w));
            }
            text.Append('}');
        }

        private static void Number(StringBuilder text, string name, float value) =>
            text.Append("  \"").Append(name).Append("\": ").Append(Exact(value)).Append(",\n");

        private static void List(StringBuilder text, params float[] values)
        {
            text.Append('[');
            for (int i = 0; i < values.Length; ++i) text.Append(i == 0 ? "" : ", ").Append(Exact(values[i]));
            text.Append(']');
        }

        private static string Exact(float value) => value.ToString("R", CultureInfo.InvariantCulture);
    }
}
