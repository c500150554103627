using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>Collects a feature's state from its renderer, the URP asset in use and the graphics settings.</summary>
    internal static class FeatureSurroundings
    {
        private const string UrpScreenSpaceShadows = "UnityEngine.Rendering.Universal.ScreenSpaceShadows";

        internal static FeatureState Of(PenumbraShadows feature)
        {
            FeatureState state = default;
            state.shaderFound = IsFound(PenumbraShadows.ShaderName);
            state.debugShaderFound = IsFound(DebugViewDraw.ShaderName);
            state.lastSkip = feature.LastSkip;
            state.missingPass = feature.MissingPass;
            state.replaced = feature.Replaced;
            state.missingGround = feature.MissingGround;
            state.asked = feature.Asked;
            state.drawn = feature.Drawn;
            GraphPass[] passes = ChainGraphs.Of(feature.Settings.Options()).SelectMany(graph => graph.passes).ToArray();
            state.shaderErrors = ShaderErrors.Of(passes);
            state.drawsCascades = passes.Any(pass => pass.kind == PassKind.Casters && pass.runs == PassFrequency.Cascade);
            state.compatibilityMode = UrpFrame.InCompatibilityMode();
            state.settings = feature.Settings;
            state.openGl = DeviceLimits.IsOpenGl;
            var asset = GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset;
            state.mainLightShadows = asset == null || asset.supportsMainLightShadows;
            if (!state.mainLightShadows) state.fixes.mainLightShadows = () => FeatureFix.CastShadows(asset);
            if (asset != null && feature.MainLight != null) ReadLight(feature.MainLight, asset, ref state);
            if (state.missingGround == FarShadowGround.NoGround) state.fixes.ground = FeatureFix.AddGround();
            ReadRenderer(RendererOf(feature), ref state);
            return state;
        }

        // URP chooses between the light's biases and the asset's in this way.
        private static void ReadLight(Light light, UniversalRenderPipelineAsset asset, ref FeatureState state)
        {
            bool own = light.TryGetComponent(out UniversalAdditionalLightData data) && !data.usePipelineSettings;
            state.depthBias = own ? light.shadowBias : asset.shadowDepthBias;
            state.normalBias = own ? light.shadowNormalBias : asset.shadowNormalBias;
            float depth = state.settings.Options().technique.Entry().hasOwnBias ? 0.0f : state.depthBias;
            if (state.normalBias > 0.0f || state.depthBias > depth)
                state.fixes.lightBias = () => FeatureFix.SetBias(light, depth);
            if (state.lastSkip == SkipReason.LightWithoutShadows)
                state.fixes.lightShadows = () => FeatureFix.CastShadows(light);
        }

        private static bool IsFound(string shaderName)
        {
            Shader shader = Shader.Find(shaderName);
            return shader != null && shader.isSupported;
        }

        private static ScriptableRendererData RendererOf(PenumbraShadows feature) =>
            AssetDatabase.LoadMainAssetAtPath(AssetDatabase.GetAssetPath(feature)) as ScriptableRendererData;

        private static void ReadRenderer(ScriptableRendererData renderer, ref FeatureState state)
        {
            if (renderer == null) return;
            ScriptableRendererFeature urps = renderer.rendererFeatures.FirstOrDefault(
                other => other != null && other.isActive && other.GetType().FullName == UrpScreenSpaceShadows);
            state.urpScreenSpaceShadows = urps != null;
            if (urps != null) state.fixes.urpScreenSpaceShadows = () => FeatureFix.Deactivate(urps);
            if (!(renderer is UniversalRendererData universal)) return;
            state.layersWithoutDepth = PrepassLayers.LeftOut(new SerializedObject(renderer));
            if (state.layersWithoutDepth != 0)
                state.fixes.prepassLayers = () => PrepassLayers.Add(new SerializedObject(renderer));
            state.depthPriming = universal.depthPrimingMode != DepthPrimingMode.Disabled;
            state.deferred = IsDeferred(universal);
#if UNITY_6000_5_OR_NEWER
            state.tileOnly = universal.tileOnlyMode;
#endif
            if (state.depthPriming) state.fixes.depthPriming = () => FeatureFix.DisableDepthPriming(universal);
        }

        /// <summary>
        /// Whether the renderer may be deferred; also true for a renderer type that is not URP's own.
        /// </summary>
        internal static bool IsDeferred(ScriptableRendererData renderer) =>
            !(renderer is UniversalRendererData universal) || (universal.renderingMode != RenderingMode.Forward &&
                                                               universal.renderingMode != RenderingMode.ForwardPlus);
    }
}
