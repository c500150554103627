using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// Exports the last frame's shadow state, to reproduce it offline: Window > Rendering > Export Penumbra Shadow
    /// State.
    /// </summary>
    internal static class ShadowStateExport
    {
        [MenuItem("Window/Rendering/Export Penumbra Shadow State...")]
        private static void Export()
        {
            var asset = GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset;
            Light sun = RenderSettings.sun;
            string problem = asset == null ? "The project does not use URP."
                : sun == null ? "There is no main light: set Lighting > Environment > Sun Source."
                : Read(asset, sun, out ShadowState state) ? Save(state)
                : "No shadow has been drawn yet: show a view in which the main light casts one, then export again.";
            if (problem != null) EditorUtility.DisplayDialog("Export Penumbra Shadow State", problem, "OK");
        }

        internal static bool Read(UniversalRenderPipelineAsset asset, Light sun, out ShadowState state)
        {
            state = default;
            Vector4 parameters = Shader.GetGlobalVector(FrameUniforms.MainLightParams);
            state.worldToShadow = Shader.GetGlobalMatrixArray("_MainLightWorldToShadow");
            if (state.worldToShadow == null || parameters.x < 1.0f) return false;
            state.cascadeCount = Mathf.Clamp((int)parameters.x, 1, AtlasLayout.MostCascades);
            state.angularDiameterDegrees = AngularDiameter.FromTanHalf(parameters.y);
            state.resolution = asset.mainLightShadowmapResolution;
            state.reversedZ = SystemInfo.usesReversedZBuffer;
            ReadBias(asset, sun, ref state);
            state.softQuality = SoftQuality((int)Shader.GetGlobalVector("_MainLightShadowParams").y);
            state.lightDirection = sun.transform.forward;
            state.splitSpheres = Spheres(state.cascadeCount);
            return true;
        }

        private static void ReadBias(UniversalRenderPipelineAsset asset, Light sun, ref ShadowState state)
        {
            bool own = sun.TryGetComponent(out UniversalAdditionalLightData data) && !data.usePipelineSettings;
            state.depthBias = own ? sun.shadowBias : asset.shadowDepthBias;
            state.normalBias = own ? sun.shadowNormalBias : asset.shadowNormalBias;
        }

        private static string SoftQuality(int quality) =>
            quality == 1 ? "low" : quality == 2 ? "medium" : quality == 3 ? "high" : "off";

        // With one cascade URP keeps the spheres of an earlier frame.
        private static Vector4[] Spheres(int cascades)
        {
            if (cascades < 2) return new Vector4[0];
            Vector4 radii = Shader.GetGlobalVector("_CascadeShadowSplitSphereRadii");
            var spheres = new Vector4[cascades];
            for (int i = 0; i < cascades; ++i)
            {
                spheres[i] = Shader.GetGlobalVector("_CascadeShadowSplitSpheres" + i);
                spheres[i].w = i == 0 ? radii.x : i == 1 ? radii.y : i == 2 ? radii.z : radii.w;
            }
            return spheres;
        }

        private static string Save(in ShadowState state)
        {
            string path = EditorUtility.SaveFilePanel("Export Penumbra Shadow State", "", "shadows.json", "json");
            if (!string.IsNullOrEmpty(path)) File.WriteAllText(path, ShadowStateJson.Write(state));
            return null;
        }
    }
}
