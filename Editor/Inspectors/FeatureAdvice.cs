using System.Collections.Generic;
using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>What of a project decides whether the feature can do its work; read by FeatureSurroundings.</summary>
    internal struct FeatureState
    {
        internal bool shaderFound;
        internal bool debugShaderFound;
        internal bool compatibilityMode;
        internal bool mainLightShadows;

        /// <summary>URP's own Screen Space Shadows feature is active in the same renderer.</summary>
        internal bool urpScreenSpaceShadows;

        internal bool depthPriming;
        internal bool deferred;

        /// <summary>The renderer keeps the picture on the GPU's tiles. Of URP 17.5.</summary>
        internal bool tileOnly;

        /// <summary>Opaque layers that the depth prepass leaves out: bits.</summary>
        internal int layersWithoutDepth;

        /// <summary>The editor draws with OpenGL or OpenGL ES.</summary>
        internal bool openGl;
        internal PenumbraShadowsSettings settings;

        /// <summary>Why the last camera was left to URP.</summary>
        internal SkipReason lastSkip;

        /// <summary>With SkipReason.MissingPass: what is missing.</summary>
        internal string missingPass;

        /// <summary>The technique draws casters of its own.</summary>
        internal bool drawsCascades;
    }

    internal readonly struct Advice
    {
        internal readonly MessageType type;
        internal readonly string text;

        internal Advice(MessageType type, string text)
        {
            this.type = type;
            this.text = text;
        }
    }

    /// <summary>What stands in a feature's way, the worst first, each with the way out.</summary>
    internal static class FeatureAdvice
    {
        internal static List<Advice> For(in FeatureState state)
        {
            var found = new List<Advice>();
            void Say(MessageType type, string text) => found.Add(new Advice(type, text));

            if (!state.shaderFound)
                Say(MessageType.Error, "The shader " + PenumbraShadows.ShaderName + " is missing or does not compile " +
                                       "for this platform. Reimport the package; URP draws its own shadows meanwhile.");
            if (state.lastSkip == SkipReason.MissingPass)
                Say(MessageType.Error, "A pass of the technique cannot run: " + state.missingPass + ". Reimport the " +
                                       "package, or choose another technique; URP draws its own shadows meanwhile.");
            if (state.compatibilityMode)
                Say(MessageType.Error, "The render graph is switched off (Project Settings > Graphics > Compatibility " +
                                       "Mode). Penumbra records with the render graph only on Unity 6: switch " +
                                       "Compatibility Mode off. URP draws its own shadows meanwhile.");
            if (state.tileOnly && state.depthPriming)
                Say(MessageType.Error, "Tile-Only Mode and Depth Priming are on in this renderer. For the depth texture that " +
                                       "this feature reads, URP then copies the primed depth, which Tile-Only Mode does not " +
                                       "allow: the frame ends with an exception. Set Depth Priming (Renderer > Rendering) to " +
                                       "Disabled.");
            if (!state.mainLightShadows)
                Say(MessageType.Warning, "Cast Shadows of the main light is off in the URP asset: there is no shadow " +
                                         "map to filter. Switch it on under Lighting > Main Light.");
            if (state.urpScreenSpaceShadows)
                Say(MessageType.Warning, "URP's Screen Space Shadows feature is active in this renderer and writes the " +
                                         "same texture. Remove it: which of the two receivers see is left to chance.");
            if (state.layersWithoutDepth != 0)
                Say(MessageType.Warning, PrepassLayers.Explanation(state.layersWithoutDepth) + " Add these layers to it " +
                                         "(Renderer > Filtering), or let Window > Rendering > Penumbra Receivers do it.");
            bool showsView = state.settings.debugView != DebugView.None;
            if (showsView && !state.debugShaderFound)
                Say(MessageType.Warning, "The shader " + DebugViewDraw.ShaderName + " is missing or does not compile for " +
                                         "this platform: no debug view is drawn. Reimport the package.");
            string skip = Skipped(state);
            if (skip != null) Say(MessageType.Info, "The last camera was left to URP: " + skip);
            if (state.settings.noise == NoiseMode.PerFrame)
                Say(MessageType.Info, "The noise moves every frame. Use that only where temporal antialiasing or an " +
                                      "upscaler averages frames; elsewhere penumbrae shimmer.");
            if (state.openGl && state.settings.Options().technique.TakesSamples())
                Say(MessageType.Info, "This editor draws with OpenGL, which does not define how PCSS reads the shadow map: " +
                                      "here PCSS is replaced by Tent 7x7. Vulkan, Direct3D and Metal have it.");
            if (state.drawsCascades)
                Say(MessageType.Info, "This technique draws the casters once more, by Unity's lists of visible objects: " +
                                      "what casts Shadows Only is not among them, and what casts none (Cast Shadows: " +
                                      "Off) is.");
            if (showsView && state.debugShaderFound)
                Say(MessageType.Info, "A debug view is drawn over the picture, here and in development builds.");
            if (!state.deferred && !state.depthPriming && !state.tileOnly)
                Say(MessageType.Info, "Forward rendering draws a depth prepass for this feature. Depth Priming (Renderer " +
                                      "> Rendering) lets the opaque pass use it too.");
            return found;
        }

        // Null where nothing was skipped, where it is meant to be, or where a message above has said it.
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
                               : "this quality level or device has no main light shadows. Look at Cast Shadows in the " +
                                 "URP asset of the quality level.";
                case SkipReason.NoMainLight:
                    return "there is no main light. It needs an active directional light, and Main Light > Per Pixel in " +
                           "the URP asset.";
                case SkipReason.LightWithoutShadows:
                    return "the main light casts none. Set its Shadow Type to Soft Shadows or Hard Shadows.";
                case SkipReason.NoShadowDistance:
                    return "the shadow distance is 0. Raise Shadows > Max Distance in the URP asset.";
                case SkipReason.NoCasters:
                    return "nothing in view casts a shadow. Look at Cast Shadows of the renderers, and at Shadows > Max " +
                           "Distance in the URP asset.";
                case SkipReason.InvalidCascade:
                    return "the engine finds no view of the light for one of the cascades, and URP then draws no shadow " +
                           "map. Look at Shadows > Cascade Count and Max Distance in the URP asset, and at Near Plane of " +
                           "the light's shadows.";
                case SkipReason.MetaQuest:
                    return "with the build profile Meta Quest, shaders of this URP version light opaque surfaces before they " +
                           "look for this feature's shadow. In shaders of your own, PenumbraMainLightVisibility of " +
                           "Shadows.hlsl works.";
                case SkipReason.UnsupportedDevice:
                    return "this device has no programs for PCSS (shader model 4.5). Choose Custom, and a tent as its " +
                           "technique.";
                default:
                    return state.lastSkip + ".";
            }
        }
    }
}
