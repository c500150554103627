using System.Collections.Generic;
using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>What of a project decides whether the feature can do its work; read by FeatureSurroundings.</summary>
    internal struct FeatureState
    {
        internal bool shaderFound;
        internal bool compatibilityMode;
        internal bool mainLightShadows;

        /// <summary>URP's own Screen Space Shadows feature is active in the same renderer.</summary>
        internal bool urpScreenSpaceShadows;

        internal bool depthPriming;
        internal bool deferred;
        internal PenumbraShadowsSettings settings;
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
            if (state.compatibilityMode)
                Say(MessageType.Error, "The render graph is switched off (Project Settings > Graphics > Compatibility " +
                                       "Mode). Penumbra records with the render graph only on Unity 6: switch " +
                                       "Compatibility Mode off. URP draws its own shadows meanwhile.");
            if (!state.mainLightShadows)
                Say(MessageType.Warning, "Cast Shadows of the main light is off in the URP asset: there is no shadow " +
                                         "map to filter. Switch it on under Lighting > Main Light.");
            if (state.urpScreenSpaceShadows)
                Say(MessageType.Warning, "URP's Screen Space Shadows feature is active in this renderer and writes the " +
                                         "same texture. Remove it: which of the two receivers see is left to chance.");
            if (state.settings.noise == NoiseMode.PerFrame)
                Say(MessageType.Info, "The noise moves every frame. Use that only where temporal antialiasing or an " +
                                      "upscaler averages frames; elsewhere penumbrae shimmer.");
            if (state.settings.debugView != DebugView.None)
                Say(MessageType.Info, "A debug view is drawn over the picture, here and in development builds.");
            if (!state.deferred && !state.depthPriming)
                Say(MessageType.Info, "Forward rendering draws a depth prepass for this feature. Depth Priming (Renderer " +
                                      "> Rendering) lets the opaque pass use it too.");
            return found;
        }
    }
}
