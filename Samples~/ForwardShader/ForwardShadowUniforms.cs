using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Samples.ForwardShader
{
    /// <summary>
    /// Sets the uniforms of ShaderLibrary/Shadows.hlsl, for projects that use it in their own shaders without the
    /// renderer feature: once per camera, because cameras may use different assets. With the feature in the renderer
    /// this is not needed, but harmless: the feature sets the same uniforms later in the frame.
    /// <para>A surface's material selects its technique; these parameters apply to all techniques.</para>
    /// </summary>
    [ExecuteAlways]
    [AddComponentMenu("Penumbra Samples/Forward Shadow Uniforms")]
    public sealed class ForwardShadowUniforms : MonoBehaviour
    {
        private static readonly int atlasTexelSize = Shader.PropertyToID("_PenumbraMainLightAtlasTexelSize");
        private static readonly int mainLightParams = Shader.PropertyToID("_PenumbraMainLightParams");

        [Tooltip("Full angle of the sun's disc in degrees: 0.53 for the real sun, several for a hazy sky.")]
        [Range(AngularDiameter.SmallestDegrees, AngularDiameter.LargestDegrees)]
        [SerializeField] private float angularDiameterDegrees = AngularDiameter.SunDegrees;

        [Tooltip("Texture fetches per pixel of the blocker search, 1 to 128. PCSS (Poisson) uses as many for its filter.")]
        [Range(1, 128)] [SerializeField] private int blockerSamples = 24;

        [Tooltip("Texture fetches per pixel that measure how much of the sun is visible, 1 to 64.")]
        [Range(1, 64)] [SerializeField] private int filterSamples = 16;

        /// <summary>The parameters of all techniques.</summary>
        internal SoftShadowParameters Parameters
        {
            get
            {
                SoftShadowParameters parameters = SoftShadowParameters.Default;
                parameters.AngularDiameterDegrees = angularDiameterDegrees;
                parameters.BlockerSamples = blockerSamples;
                parameters.FilterSamples = filterSamples;
                return parameters;
            }
        }

        private void OnEnable() { RenderPipelineManager.beginCameraRendering += BeforeCamera; }
        private void OnDisable() { RenderPipelineManager.beginCameraRendering -= BeforeCamera; }

        private void BeforeCamera(ScriptableRenderContext context, Camera camera)
        {
            if (GraphicsSettings.currentRenderPipeline is UniversalRenderPipelineAsset asset)
                Set(Parameters, new AtlasLayout(asset.mainLightShadowmapResolution, asset.shadowCascadeCount));
        }

        /// <summary>
        /// Sets the uniforms. The noise is static: without a temporal filter, changing noise would flicker.
        /// </summary>
        internal static void Set(in SoftShadowParameters parameters, in AtlasLayout layout)
        {
            var uniforms = new ShadowUniforms(parameters, layout, 0);
            Shader.SetGlobalVector(atlasTexelSize, uniforms.MainLightAtlasTexelSize);
            Shader.SetGlobalVector(mainLightParams, uniforms.MainLightParams);
            Shader.SetGlobalVector(PcssAngularParameters.Uniform0, uniforms.PcssAngular.Vector0);
            Shader.SetGlobalVector(PcssAngularParameters.Uniform1, uniforms.PcssAngular.Vector1);
            Shader.SetGlobalVector(PcssClassicParameters.Uniform0, uniforms.PcssClassic.Vector0);
            Shader.SetGlobalVector(PcssHdrpParameters.Uniform0, uniforms.PcssHdrp.Vector0);
            Shader.SetGlobalVector(PcssHdrpParameters.Uniform1, uniforms.PcssHdrp.Vector1);
            PcssSpotParameters spot = PcssSpotParameters.Default;
            spot.blockerSamples = parameters.BlockerSamples;
            spot.filterSamples = parameters.FilterSamples;
            Shader.SetGlobalVector(PcssSpotParameters.Uniform0, spot.Vector0);
        }
    }
}
