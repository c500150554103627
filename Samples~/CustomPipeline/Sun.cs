using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>The light that this pipeline uses: the first directional light that casts shadows.</summary>
    internal static class Sun
    {
        internal const int None = -1;

        private static readonly int direction = Shader.PropertyToID("_SunDirection");
        private static readonly int color = Shader.PropertyToID("_SunColor");
        private static readonly int ambientColor = Shader.PropertyToID("_Ambient");

        /// <summary>The sun's index in the visible lights; None if there is none.</summary>
        internal static int Index(NativeArray<VisibleLight> lights)
        {
            for (int i = 0; i < lights.Length; ++i)
            {
                Light light = lights[i].light;
                if (light == null || light.type != LightType.Directional) continue;
                if (light.shadows != LightShadows.None) return i;
            }
            return None;
        }

        /// <summary>Sets the sun's uniforms; without a sun its colour is black.</summary>
        internal static void SetUniforms(CommandBuffer commands, NativeArray<VisibleLight> lights, int index,
                                         float ambient)
        {
            commands.SetGlobalVector(ambientColor, new Vector4(ambient, ambient, ambient, 0.0f));
            if (index == None)
            {
                commands.SetGlobalVector(color, Vector4.zero);
                return;
            }
            Light light = lights[index].light;
            Vector3 forward = light.transform.forward;
            Color linear = Linear(light.color);
            float intensity = light.intensity;
            commands.SetGlobalVector(direction, new Vector4(-forward.x, -forward.y, -forward.z, 0.0f));
            commands.SetGlobalVector(color, new Vector4(linear.r * intensity, linear.g * intensity,
                                                        linear.b * intensity, 0.0f));
        }

        /// <summary>
        /// Converts a colour to linear: colours are picked in sRGB, but lights are added in linear space.
        /// </summary>
        internal static Color Linear(Color picked) =>
            new Color(Mathf.GammaToLinearSpace(picked.r), Mathf.GammaToLinearSpace(picked.g),
                      Mathf.GammaToLinearSpace(picked.b), picked.a);
    }
}
