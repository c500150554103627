using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Soft, contact-hardening shadows of the main light for every opaque receiver, in forward, forward+ and deferred:
    /// add it to the renderer and choose a preset. It fills the screen-space shadow texture that URP's own shaders
    /// already read, so that URP itself is not modified; transparents and additional lights keep URP's shadows.
    /// </summary>
    [DisallowMultipleRendererFeature(PenumbraShadows.Title)]
#if UNITY_6000_0_OR_NEWER
    [SupportedOnRenderer(typeof(UniversalRendererData))]
#endif
    [Tooltip("Soft shadows of the main light, with presets whose error was measured.")]
    [PackagePage("renderer-feature.md")]
    public sealed class PenumbraShadows : ScriptableRendererFeature
    {
        /// <summary>The name in menus and headers, of the Volume override, too.</summary>
        internal const string Title = "Penumbra Soft Shadows";

        internal const string ShaderName = "Hidden/Penumbra/Shadows";

        /// <summary>Path of the feature's shader in the package, as graphs refer to it.</summary>
        internal const string ShaderFile = "Shaders/PenumbraShadows.shader";

#if UNITY_EDITOR
        // The attribute keeps the variants of URP's shaders that read the screen-space texture in the player.
        [UnityEditor.ShaderKeywordFilter.SelectIf(true, keywordNames: ShadowKeywords.ScreenName)]
        private const bool RequiresScreenSpaceShadows = !UrpFrame.MetaQuest;
#endif

        [Tooltip("The passes' shader. Set automatically; this reference includes it in players.")]
        [SerializeField] private Shader shader;

        [Tooltip("The debug views' shader. Set automatically.")]
        [SerializeField] private Shader debugShader;

        [Tooltip("Further shaders of the passes. Set automatically.")]
        [SerializeField] private PassAssets passAssets = new PassAssets();

        [Tooltip("The feature's options.")]
        [SerializeField] private PenumbraShadowsSettings settings = new PenumbraShadowsSettings();

        private Material material;
        private Material debugMaterial;
        private ChainDraw draw;
        private DebugViewDraw debugDraw;
#if UNITY_6000_0_OR_NEWER
        private GraphShadowPass shadowPass;
        private GraphRestorePass restorePass;
        private GraphDebugPass debugPass;
#else
        private ClassicShadowPass shadowPass;
        private ClassicRestorePass restorePass;
        private ClassicDebugPass debugPass;
#endif

        /// <summary>The settings of this feature, without the overrides of Volumes.</summary>
        public PenumbraShadowsSettings Settings => settings;

        /// <summary>The reason why the last camera was skipped and has URP's shadows; None if it was not.</summary>
        internal SkipReason LastSkip { get; private set; }

        /// <summary>The main light of the last camera that was no preview; null if it had none.</summary>
        internal Light MainLight { get; private set; }

        /// <summary>The message that says what is missing, with SkipReason.MissingPass.</summary>
        internal string MissingPass { get; private set; }

        /// <summary>
        /// The reason why the last camera's options were replaced by others that this device can draw, as a message;
        /// null if they were not.
        /// </summary>
        internal string Replaced { get; private set; }

        /// <summary>
        /// The reason why the last camera has no shadows of the ground beyond the cascades though they are on, as a
        /// message; null if it has them or they are off.
        /// </summary>
        internal string MissingGround { get; private set; }

        /// <summary>The last camera's options, and those that were drawn.</summary>
        internal ShadowOptions Asked { get; private set; }
        internal ShadowOptions Drawn { get; private set; }

        /// <inheritdoc/>
        public override void Create()
        {
#if UNITY_6000_0_OR_NEWER
            shadowPass = shadowPass ?? new GraphShadowPass();
            restorePass = restorePass ?? new GraphRestorePass(shadowPass);
            debugPass = debugPass ?? new GraphDebugPass(shadowPass);
#else
            shadowPass = shadowPass ?? new ClassicShadowPass();
            restorePass = restorePass ?? new ClassicRestorePass(shadowPass);
            debugPass = debugPass ?? new ClassicDebugPass(shadowPass);
#endif
            FindShaders();
            TechniqueTable.Load(passAssets.Techniques);
            draw?.Dispose();
            LeftOpen.Watch(this);
        }

        /// <inheritdoc/>
        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            ShadowSource source = UrpFrame.Source(ref renderingData);
            LastSkip = Reason(source);
            if (source.cameraType != CameraType.Preview) MainLight = source.light;
            if (LastSkip != SkipReason.None) return;

            ShadowOptions options = Options();
            FarFrame far = Far(source, renderingData.cameraData.camera, ref options);
            SkipReason withoutMap = FrameGate.WithoutMap(source);
            if (withoutMap != SkipReason.None && !options.DrawsBeyondCascades)
            {
                LastSkip = withoutMap;
                return;
            }
            Asked = options;
            MissingPass = draw.Prepare(ref options, source.views, withoutMap != SkipReason.None);
            Drawn = options;
            Replaced = draw.Replaces;
            if (MissingPass != null)
            {
                LastSkip = SkipReason.MissingPass;
                return;
            }
            ShadowFrame frame = UrpFrame.Frame(source, options, settings.noise);
            frame.far = far;
            shadowPass.Setup(draw, frame);
#if !UNITY_6000_0_OR_NEWER
            shadowPass.SetPath(UrpFrame.IsDeferred(renderer, renderingData.cameraData));
#endif
            renderer.EnqueuePass(shadowPass);
            renderer.EnqueuePass(restorePass);
            if (options.debugView == DebugView.None || !LoadDebugMaterial()) return;
            debugPass.Setup(debugDraw);
            renderer.EnqueuePass(debugPass);
        }

        // The options are the feature's, overridden by the project's default Volumes and those of the scene.
        private ShadowOptions Options()
        {
            ShadowOptions options = settings.Options();
#if UNITY_6000_0_OR_NEWER
            options = DefaultVolumes.Over(options);
#endif
            PenumbraShadowsVolume volume = VolumeManager.instance.stack.GetComponent<PenumbraShadowsVolume>();
            return volume != null ? volume.Over(options) : options;
        }

        // Without ground, the options' far shadows are switched off.
        private FarFrame Far(in ShadowSource source, Camera camera, ref ShadowOptions options)
        {
            MissingGround = null;
            if (!options.DrawsBeyondCascades) return default;
            Vector3 position = camera.transform.position;
            FarFrame far = FarFrame.Of(settings.farShadows, source, position);
            if (options.farShadows == FarShadowMode.Off) return far;
            MissingGround = FarShadowGround.Find(options.farShadows, position, out far.ground);
            if (MissingGround != null) options.farShadows = FarShadowMode.Off;
            return far;
        }

        private SkipReason Reason(in ShadowSource source)
        {
            SkipReason reason = FrameGate.Reason(source, settings);
            if (reason != SkipReason.None) return reason;
            if (UrpFrame.InCompatibilityMode()) return SkipReason.CompatibilityMode;
            if (!LoadTechniques()) return SkipReason.MissingPass;
            return LoadMaterial() ? SkipReason.None : SkipReason.MissingShader;
        }

        private bool LoadTechniques()
        {
            if (TechniqueTable.Problem != null) FindShaders();
            MissingPass = TechniqueTable.Problem;
            return MissingPass == null;
        }

        /// <summary>
        /// Stores references to the shaders and the file of techniques in the renderer asset, because a player contains
        /// only referenced assets.
        /// </summary>
        internal void FindShaders()
        {
#if UNITY_EDITOR
            bool changed = passAssets.Find(TechniqueTable.File);
            if (TechniqueTable.Load(passAssets.Techniques)) changed |= passAssets.Find(ChainGraphs.All);
            changed |= Find(ref shader, ShaderName);
            changed |= Find(ref debugShader, DebugViewDraw.ShaderName);
            if (changed) UnityEditor.EditorUtility.SetDirty(this);
#endif
        }

        private static bool Find(ref Shader shader, string name)
        {
            if (shader != null) return false;
            shader = Shader.Find(name);
            return shader != null;
        }

        private bool LoadMaterial()
        {
            if (material != null) return true;
            material = MaterialOf(ref shader, ShaderName);
            if (material == null) return false;
            draw = new ChainDraw(material, passAssets);
            return true;
        }

        // A release player contains the debug shader, but none of its variants.
        private bool LoadDebugMaterial()
        {
            if (!Debug.isDebugBuild) return false;
            if (debugMaterial != null) return true;
            debugMaterial = MaterialOf(ref debugShader, DebugViewDraw.ShaderName);
            if (debugMaterial == null) return false;
            debugDraw = new DebugViewDraw(debugMaterial);
            return true;
        }

        private static Material MaterialOf(ref Shader shader, string name)
        {
            Find(ref shader, name);
            return shader != null && shader.isSupported ? CoreUtils.CreateEngineMaterial(shader) : null;
        }

        /// <inheritdoc/>
        protected override void Dispose(bool disposing)
        {
            LeftOpen.Forget(this);
            shadowPass?.Dispose();
            shadowPass = null;
            restorePass = null;
            debugPass = null;
            draw?.Dispose();
            draw = null;
            debugDraw = null;
            CoreUtils.Destroy(material);
            CoreUtils.Destroy(debugMaterial);
            material = debugMaterial = null;
        }
    }
}
