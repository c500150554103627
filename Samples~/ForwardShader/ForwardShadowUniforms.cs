using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Samples.ForwardShader
{
    /// <summary>
    /// Sets what ShaderLibrary/Shadows.hlsl reads, for projects that use it in shaders of their own without the
    /// renderer feature: once a camera, because cameras may use different assets. With the feature in the renderer this
    /// is not needed, and does no harm: the feature sets the same uniforms later in the frame.
    /// <para>Which technique a surface uses is its material's choice; this is what all of them are told.</para>
    /// </summary>
    [ExecuteAlways]
    [AddComponentMenu("Penumbra Samples/Forward Shadow Uniforms")]
    public sealed class ForwardShadowUniforms : MonoBehaviour
    {
        private static readonly int atlasTexelSize = Shader.PropertyToID("_PenumbraMainLightAtlasTexelSize");
        private static readonly int mainLightParams = Shader.PropertyToID("_PenumbraMainLightParams");

        [Tooltip("Full angle of the sun's disc in degrees: the real one's is 0.53, a hazy sky is like several.")]
        [Range(AngularDiameter.SmallestDegrees, AngularDiameter.LargestDegrees)]
        [SerializeField] private float angularDiameterDegrees = AngularDiameter.SunDegrees;

        [Tooltip("Texture fetches per pixel of the blocker search, 1 to 128. PCSS (Poisson) takes as many for its filter.")]
        [Range(1, 128)] [SerializeField] private int blockerSamples = 24;

        [Tooltip("Texture fetches per pixel that measure how much of the sun is seen, 1 to 64.")]
        [Range(1, 64)] [SerializeField] private int filterSamples = 16;

        /// <summary>What all techniques are told.</summary>
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

        /// <summary>The noise stands still: without a temporal filter a moving one would flicker.</summary>
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
        }
    }
}
