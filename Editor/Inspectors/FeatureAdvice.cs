using System;
using System.Collections.Generic;
using System.Globalization;
using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>The project's state that decides whether the feature works; collected by FeatureSurroundings.</summary>
    internal struct FeatureState
    {
        internal bool shaderFound;
        internal bool debugShaderFound;

        /// <summary>
        /// The errors, by file and line, of shaders of the technique's passes that do not compile; null if all do.
        /// </summary>
        internal string shaderErrors;
        internal bool compatibilityMode;
        internal bool mainLightShadows;

        /// <summary>The biases that URP gives the main light; 0 without one.</summary>
        internal float depthBias;
        internal float normalBias;

        /// <summary>Whether URP's own Screen Space Shadows feature is active in the same renderer.</summary>
        internal bool urpScreenSpaceShadows;

        internal bool depthPriming;
        internal bool deferred;

        /// <summary>
        /// Whether the renderer uses Tile-Only Mode of URP 17.5, which keeps the image in tile memory.
        /// </summary>
        internal bool tileOnly;

        /// <summary>Bit mask of the opaque layers that the depth prepass excludes.</summary>
        internal int layersWithoutDepth;

        /// <summary>Whether the editor uses OpenGL or OpenGL ES.</summary>
        internal bool openGl;
        internal PenumbraShadowsSettings settings;

        /// <summary>The reason why the last camera was skipped.</summary>
        internal SkipReason lastSkip;

        /// <summary>The message that says what is missing, with SkipReason.MissingPass.</summary>
        internal string missingPass;

        /// <summary>
        /// The reason why the last camera's options were replaced, as a message, or null; and the options before and
        /// after.
        /// </summary>
        internal string replaced;
        internal ShadowOptions asked;

        /// <summary>The reason why the last camera has no shadows of the ground, as a message, or null.</summary>
        internal string missingGround;
        internal ShadowOptions drawn;

        /// <summary>Whether the technique has passes that draw the casters per cascade.</summary>
        internal bool drawsCascades;

        internal FeatureFixes fixes;
    }

    internal readonly struct Advice
    {
        internal readonly MessageType type;
        internal readonly string text;

        /// <summary>The action of a button beside the text; null for no button.</summary>
        internal readonly Action action;
        internal readonly string button;

        internal Advice(MessageType type, string text, Action action = null, string button = "Fix")
        {
            this.type = type;
            this.text = text;
            this.action = action;
            this.button = button;
        }
    }

    /// <summary>Lists what prevents the feature from working, most severe first, each with a remedy.</summary>
    internal static class FeatureAdvice
    {
        internal static List<Advice> For(in FeatureState state)
        {
            var found = new List<Advice>();
            void Say(MessageType type, string text, Action fix = null) => found.Add(new Advice(type, text, fix));

            if (state.shaderErrors != null)
                Say(MessageType.Error, "Shaders of the technique do not compile, so that another is drawn or none:\n" +
                                       state.shaderErrors);
            if (!state.shaderFound)
                Say(MessageType.Error, "The shader " + PenumbraShadows.ShaderName + " is missing or does not compile " +
                                       "for this platform. Reimport the package; URP draws its own shadows meanwhile.");
            if (state.lastSkip == SkipReason.MissingPass)
                Say(MessageType.Error, "A pass of the technique cannot run: " + state.missingPass + ". Reimport the " +
                                       "package, or choose another technique; URP draws its own shadows meanwhile.");
            // Other features of the project may need that mode, and URP does not follow an undo of it.
            if (state.compatibilityMode)
                found.Add(new Advice(MessageType.Error,
                                     "The render graph is switched off (Project Settings > Graphics > Compatibility Mode). " +
                                     "Penumbra records with the render graph only on Unity 6: switch Compatibility Mode " +
                                     "off. URP draws its own shadows meanwhile.",
                                     () => SettingsService.OpenProjectSettings("Project/Graphics"), "Open"));
            if (state.tileOnly && state.depthPriming)
                Say(MessageType.Error, "Tile-Only Mode and Depth Priming are on in this renderer. For the depth texture that " +
                                       "this feature reads, URP then copies the primed depth, which Tile-Only Mode does not " +
                                       "allow: the frame ends with an exception. Set Depth Priming (Renderer > Rendering) to " +
                                       "Disabled.", state.fixes.depthPriming);
            if (!state.mainLightShadows)
                Say(MessageType.Warning, "Cast Shadows of the main light is off in the URP asset: there is no shadow " +
                                         "map to filter. Switch it on under Lighting > Main Light.",
                    state.fixes.mainLightShadows);
            if (state.urpScreenSpaceShadows)
                Say(MessageType.Warning, "URP's Screen Space Shadows feature is active in this renderer and writes the " +
                                         "same texture. Remove it, or switch it off: which of the two results receivers read is " +
                                         "undefined.", state.fixes.urpScreenSpaceShadows);
            bool hasOwnBias = state.settings.Options().technique.Entry().hasOwnBias;
            if (!hasOwnBias && state.normalBias > 0.0f)
                Say(MessageType.Warning, string.Format(CultureInfo.InvariantCulture,
                                                       "The main light's Normal Bias is {0:0.##}, which makes casters smaller: " +
                                                       "light leaks in where objects stand on the ground, and much of this " +
                                                       "feature's advantage is lost. Set it to 0: on the light (Shadows > Bias: " +
                                                       "Custom), or for all lights in the URP asset.", state.normalBias),
                    state.fixes.lightBias);
            if (state.layersWithoutDepth != 0)
                Say(MessageType.Warning, PrepassLayers.Explanation(state.layersWithoutDepth) + " Add these layers to it " +
                                         "(Renderer > Filtering).", state.fixes.prepassLayers);
            // A preset is made for this, so nothing is to be mended.
            bool isOfPreset = state.settings.preset != QualityPreset.Custom &&
                              state.asked.technique == ShadowPresets.Options(state.settings.preset).technique;
            if (state.replaced != null && isOfPreset)
                Say(MessageType.Info, "The preset " + state.settings.preset + " draws " +
                                      TechniqueName.Of(state.asked.technique) + " where the device can. This one cannot: " +
                                      state.replaced + ". Drawn instead: " + Substitute(state) + ".");
            else if (state.replaced != null)
                Say(MessageType.Warning, TechniqueName.Of(state.asked.technique) + " cannot run here as it is set: " +
                                         state.replaced + ". Drawn instead: " + Substitute(state) + ".");
            if (state.missingGround != null)
                Say(MessageType.Warning, "Far Shadows are on, but " + state.missingGround + ". Nothing beyond the shadow distance " +
                                         "is shadowed by the ground meanwhile.", state.fixes.ground);
            bool showsView = state.settings.debugView != DebugView.None;
            if (showsView && !state.debugShaderFound)
                Say(MessageType.Warning, "The shader " + DebugViewDraw.ShaderName + " is missing or does not compile for " +
                                         "this platform: no debug view is drawn. Reimport the package.");
            string skip = Skipped(state);
            if (skip != null) Say(MessageType.Info, "The last camera was skipped and has URP's shadows: " + skip,
                                  state.fixes.lightShadows);
            if (state.settings.noise == NoiseMode.PerFrame)
                Say(MessageType.Info, "The noise of samples changes every frame. Use that only where temporal antialiasing or " +
                                      "an upscaler averages frames; elsewhere sampled penumbrae flicker.");
            ShadowOptions options = state.settings.Options();
            string technique = TechniqueName.Of(options.technique);
            if (options.accumulates && !options.HasNoise)
                Say(MessageType.Info, "Noise is Accumulated, and " + technique + " has none: no frames are averaged.");
            if (state.openGl && !options.HasPasses && ChainSubstitute.Has(options.technique))
                Say(MessageType.Info, "This editor draws with OpenGL, which does not define how " + technique + " reads the " +
                                      "shadow map: here it is replaced by " +
                                      TechniqueName.Of(options.technique.Entry().fallback) +
                                      ". Vulkan, Direct3D and Metal support it.");
            if (hasOwnBias)
                Say(MessageType.Info, technique + " biases receivers itself, as its engine does. Set Bias of the light to " +
                                      "Custom, with Depth and Normal 0.", state.fixes.lightBias);
            if (state.drawsCascades)
                Say(MessageType.Info, "This technique draws the casters once more, from Unity's lists of visible objects. " +
                                      "Objects whose Cast Shadows is Shadows Only are missing there, and those with " +
                                      "Off are included.");
            if (showsView && state.debugShaderFound)
                Say(MessageType.Info, "A debug view is drawn over the image, here and in development builds.");
            ShadowOptions drawn = state.replaced != null ? state.drawn : options;
            if (state.settings.debugView == DebugView.PenumbraMask && state.debugShaderFound && !drawn.HasMask)
                Say(MessageType.Info, "The view Penumbra Mask is yellow everywhere: " +
                                      (drawn.SamplesPenumbrae ? "Mask is off" : PresetText.Technique(drawn) + " has no mask") +
                                      ".");
            if (!state.deferred && !state.depthPriming && !state.tileOnly)
                Say(MessageType.Info, "Forward rendering draws a depth prepass for this feature. Depth Priming (Renderer " +
                                      "> Rendering) lets the opaque pass use it too.");
            return found;
        }

        private static string Substitute(in FeatureState state)
        {
            if (state.drawn.technique != state.asked.technique) return TechniqueName.Of(Computed(state));
            if (state.drawn.clouds != state.asked.clouds) return "the same without cloud shadows";
            return state.drawn.mapFormat != state.asked.mapFormat
                       ? "the same with maps of 16 bits" : "the same with the mask of four comparisons";
        }

        // On OpenGL, shaders compute another filter in the place of one that reads the shadow map: see
        // DeviceLimits.IsOpenGl.
        private static ShadowTechnique Computed(in FeatureState state) =>
            state.openGl ? state.drawn.technique.Entry().fallback : state.drawn.technique;

        // Returns null if nothing was skipped, if skipping is intended, or if another message already explains it.
        private static string Skipped(in FeatureState state)
        {
            switch (state.lastSkip)
            {
                case SkipReason.None:
                case SkipReason.PreviewCamera:
                case SkipReason.DepthOnlyCamera:
                case SkipReason.SceneViewOff:
                case SkipReason.ReflectionProbesOff:
                case SkipReason.MissingShader:
                case SkipReason.MissingPass:
                case SkipReason.CompatibilityMode:
                    return null;
                case SkipReason.SceneLightingOff:
                    return "scene lighting is off. Switch on the light bulb in the Scene view's toolbar.";
                case SkipReason.ShadowsOff:
                    return !state.mainLightShadows ? null
                               : "this quality level or device has no main light shadows. Check Cast Shadows in the " +
                                 "URP asset of the quality level.";
                case SkipReason.NoMainLight:
                    return "there is no main light. It needs an active directional light, and Main Light > Per Pixel in " +
                           "the URP asset.";
                case SkipReason.LightWithoutShadows:
                    return "the main light casts no shadows. Set its Shadow Type to Soft Shadows or Hard Shadows.";
                case SkipReason.NoShadowDistance:
                    return "the shadow distance is 0. Raise Shadows > Max Distance in the URP asset.";
                case SkipReason.NoCasters:
                    return "nothing in view casts a shadow. Check Cast Shadows of the renderers, and Shadows > Max " +
                           "Distance in the URP asset.";
                case SkipReason.InvalidCascade:
                    return "the engine cannot compute the light's view for one of the cascades, and URP then draws no " +
                           "shadow map. Check Shadows > Cascade Count and Max Distance in the URP asset, and Near Plane of " +
                           "the light's shadows.";
                case SkipReason.MetaQuest:
                    return "with the build profile Meta Quest, shaders of this URP version treat opaque surfaces as lit and " +
                           "do not read this feature's shadow. In your own shaders, PenumbraMainLightVisibility " +
                           "of Shadows.hlsl works.";
                default:
                    return state.lastSkip + ".";
            }
        }
    }
}
