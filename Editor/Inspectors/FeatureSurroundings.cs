using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// Collects a feature's state from its renderer, the URP asset in use and the graphics settings.
    /// </summary>
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
            ReadRenderer(RendererOf(feature), ref state);
            return state;
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
            foreach (ScriptableRendererFeature other in renderer.rendererFeatures)
                state.urpScreenSpaceShadows |= other != null && other.isActive &&
                                               other.GetType().FullName == UrpScreenSpaceShadows;
            if (!(renderer is UniversalRendererData universal)) return;
            state.layersWithoutDepth = PrepassLayers.LeftOut(new SerializedObject(renderer));
            state.depthPriming = universal.depthPrimingMode != DepthPrimingMode.Disabled;
            state.deferred = IsDeferred(universal);
#if UNITY_6000_5_OR_NEWER
            state.tileOnly = universal.tileOnlyMode;
#endif
        }

        /// <summary>Also true for a renderer type that is not URP's own, as it may be deferred.</summary>
        internal static bool IsDeferred(ScriptableRendererData renderer) =>
            !(renderer is UniversalRendererData universal) || (universal.renderingMode != RenderingMode.Forward &&
                                                               universal.renderingMode != RenderingMode.ForwardPlus);
    }
}
