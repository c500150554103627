using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Soft, contact-hardening shadows of the main light for every opaque receiver, in forward, forward+ and deferred:
    /// add it to the renderer and choose a preset. It fills the screen-space shadow texture that URP's own shaders
    /// already know how to read, so nothing of URP is patched; transparents and additional lights keep URP's shadows.
    /// </summary>
    [DisallowMultipleRendererFeature("Penumbra Soft Shadows")]
    [Tooltip("Soft shadows of the main light, with presets whose error is known.")]
    public sealed class PenumbraShadows : ScriptableRendererFeature
    {
        internal const string ShaderName = "Hidden/Penumbra/Shadows";

#if UNITY_EDITOR
        // Keeps the variants of URP's shaders that read the screen-space texture in the player.
        [UnityEditor.ShaderKeywordFilter.SelectIf(true, keywordNames: ShadowKeywords.ScreenName)]
        private const bool RequiresScreenSpaceShadows = true;
#endif

        [SerializeField] private Shader shader;
        [SerializeField] private PenumbraShadowsSettings settings = new PenumbraShadowsSettings();

        private Material material;
        private ChainDraw draw;
#if UNITY_6000_0_OR_NEWER
        private GraphShadowPass shadowPass;
        private GraphRestorePass restorePass;
#else
        private ClassicShadowPass shadowPass;
        private ClassicRestorePass restorePass;
#endif

        /// <summary>Of this feature; what Volumes override is not in it.</summary>
        public PenumbraShadowsSettings Settings => settings;

        /// <summary>Why the last camera was left to URP; None when it was not.</summary>
        internal SkipReason LastSkip { get; private set; }

        /// <inheritdoc/>
        public override void Create()
        {
#if UNITY_6000_0_OR_NEWER
            shadowPass = shadowPass ?? new GraphShadowPass();
            restorePass = restorePass ?? new GraphRestorePass();
#else
            shadowPass = shadowPass ?? new ClassicShadowPass();
            restorePass = restorePass ?? new ClassicRestorePass();
#endif
            KeepShader();
            LeftOpen.Watch(this);
        }

        /// <inheritdoc/>
        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            ShadowSource source = UrpFrame.Source(ref renderingData);
            LastSkip = Reason(source);
            if (LastSkip != SkipReason.None) return;

            PenumbraShadowsVolume volume = VolumeManager.instance.stack.GetComponent<PenumbraShadowsVolume>();
            ShadowOptions options = settings.Options();
            if (volume != null) options = volume.Over(options);
            draw.Prepare(options);
            shadowPass.Setup(draw, UrpFrame.Frame(source, options, settings.noise));
            renderer.EnqueuePass(shadowPass);
            renderer.EnqueuePass(restorePass);
        }

        private SkipReason Reason(in ShadowSource source)
        {
            SkipReason reason = FrameGate.Reason(source, settings);
            if (reason != SkipReason.None) return reason;
            if (UrpFrame.InCompatibilityMode()) return SkipReason.CompatibilityMode;
            return LoadMaterial() ? SkipReason.None : SkipReason.MissingShader;
        }

        // A player contains what is referenced: the asset remembers the shader as soon as the editor has found it.
        private void KeepShader()
        {
#if UNITY_EDITOR
            if (shader != null) return;
            shader = Shader.Find(ShaderName);
            if (shader != null) UnityEditor.EditorUtility.SetDirty(this);
#endif
        }

        private bool LoadMaterial()
        {
            if (material != null) return true;
            if (shader == null) shader = Shader.Find(ShaderName);
            if (shader == null || !shader.isSupported) return false;
            material = CoreUtils.CreateEngineMaterial(shader);
            draw = new ChainDraw(material);
            return true;
        }

        /// <inheritdoc/>
        protected override void Dispose(bool disposing)
        {
            LeftOpen.Forget(this);
#if !UNITY_6000_0_OR_NEWER
            shadowPass?.Dispose();
#endif
            shadowPass = null;
            restorePass = null;
            draw = null;
            CoreUtils.Destroy(material);
            material = null;
        }
    }
}
