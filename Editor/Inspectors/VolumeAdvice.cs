using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>A Volume's overrides, and the project's state that decides their effect.</summary>
    internal struct VolumeState
    {
        internal PenumbraShadowsVolume volume;

        /// <summary>The settings of the active features of the project's renderers.</summary>
        internal IReadOnlyList<PenumbraShadowsSettings> features;

        /// <summary>
        /// Whether the Volume is in the project's default profile (Unity 6), where every parameter is overridden.
        /// </summary>
        internal bool defaultProfile;
    }

    /// <summary>
    /// Tells which options a Volume's inspector shows, and has its messages, most severe first, each with a remedy.
    /// </summary>
    internal static class VolumeAdvice
    {
        /// <summary>
        /// Whether the inspector shows the option. An overridden option without effect is still shown, so that its
        /// override can be cleared.
        /// </summary>
        internal static bool Shows(OptionField option, PenumbraShadowsVolume volume) =>
            option.IsInVolume &&
            (option.IsOverridden(volume) || Possible(volume).Any(options => option.Counts(options)));

        /// <summary>
        /// The overridden preset's options and its figures under the current light; null without such a preset.
        /// </summary>
        internal static string Preset(in VolumeState state)
        {
            PenumbraShadowsVolume volume = state.volume;
            if (state.defaultProfile || !HasPreset(volume)) return null;
            QualityPreset preset = volume.preset.value;
            return PresetText.Describe(ShadowPresets.Options(preset)) + "\n" +
                   (volume.angularDiameterDegrees.overrideState
                        ? PresetText.Figures(preset, volume.angularDiameterDegrees.value)
                        : FiguresUnderTheFeaturesLight(preset, state.features));
        }

        internal static List<Advice> For(in VolumeState state)
        {
            var found = new List<Advice>();
            void Say(MessageType type, string text) => found.Add(new Advice(type, text));

            if (state.defaultProfile)
            {
                Say(MessageType.Info, "The default profile does not override Penumbra: the feature's options apply where " +
                                      "no Volume of a scene overrides them. Blending Volumes start from these values.");
                return found;
            }
            if (state.features.Count == 0)
                Say(MessageType.Warning, "No renderer of this project has an active Penumbra Soft Shadows feature, so this " +
                                         "has no effect. Select the renderer that the URP asset uses and Add Renderer " +
                                         "Feature > Penumbra Soft Shadows.");
            PenumbraShadowsVolume volume = state.volume;
            if (volume.preset.overrideState && !HasPreset(volume))
                Say(MessageType.Info, "Custom changes nothing by itself: options that are not overridden below are the " +
                                      "feature's. Override single options, or choose a preset.");
            List<string> beside = Beside(volume);
            if (beside.Count > 0)
                Say(MessageType.Info, Join(beside, "overrides", "override") + " the preset, whose figures no longer apply. " +
                                      "Clear the checkbox to use the preset's value.");
            SayWhatIsIdle(state, Say);
            return found;
        }

        private static void SayWhatIsIdle(in VolumeState state, System.Action<MessageType, string> say)
        {
            PenumbraShadowsVolume volume = state.volume;
            List<string> idle = Idle(volume, Possible(volume).ToArray());
            SayOf(idle, new[] { Decided(volume) }, "", "Clear the checkbox, or change the technique or preset.");

            ShadowOptions[] features = state.features.Select(feature => volume.Over(feature.Options())).ToArray();
            if (features.Length == 0) return;
            SayOf(Idle(volume, features).Except(idle).ToList(), features, ", which the feature selects",
                  "Override the technique or preset too.");

            // Some of these options have an effect on what stands in for the technique.
            void SayOf(List<string> options, ShadowOptions[] inForce, string whose, string remedy)
            {
                ShadowOptions[] replaced = inForce.Where(one => ChainSubstitute.TryGetSampled(one, out _)).ToArray();
                ShadowOptions[] instead = replaced.Select(Substitute).ToArray();
                List<string> onlyInstead = options.Except(Idle(volume, instead)).ToList();
                options = options.Except(onlyInstead).ToList();
                string without = " no effect with " + Techniques(inForce) + whose;
                if (options.Count > 0) say(MessageType.Info, Join(options, "has", "have") + without + ". " + remedy);
                if (onlyInstead.Count > 0)
                    say(MessageType.Info, Join(onlyInstead, "has", "have") + without + ", only with " + Techniques(instead) +
                                          " on devices that cannot run " + Techniques(replaced) + ".");
            }
        }

        private static ShadowOptions Substitute(ShadowOptions options)
        {
            ChainSubstitute.TryGetSampled(options, out ShadowOptions instead);
            return instead;
        }

        // Everything but the technique that a Volume does not override can have any value; with these options all
        // fields of the technique have an effect. Where the technique is not overridden either, it is the one on which
        // most options have an effect.
        private static ShadowOptions Decided(PenumbraShadowsVolume volume)
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.High);
            options.technique = ShadowTechnique.Pcss;
            options.mask = true;
            return volume.Over(options);
        }

        // The options with every technique that the Volume leaves to the feature.
        private static IEnumerable<ShadowOptions> Possible(PenumbraShadowsVolume volume)
        {
            ShadowOptions options = Decided(volume);
            if (volume.technique.overrideState || HasPreset(volume)) return new[] { options };
            return ((ShadowTechnique[])System.Enum.GetValues(typeof(ShadowTechnique))).Select(technique =>
            {
                ShadowOptions possible = options;
                possible.technique = technique;
                return possible;
            });
        }

        private static bool HasPreset(PenumbraShadowsVolume volume) =>
            volume.preset.overrideState && volume.preset.value != QualityPreset.Custom;

        private static string FiguresUnderTheFeaturesLight(QualityPreset preset,
                                                           IEnumerable<PenumbraShadowsSettings> features)
        {
            float[] lights = features.Select(feature => feature.Options().angularDiameterDegrees).Distinct().ToArray();
            if (lights.Length != 1)
                return PresetText.Figures(preset, AngularDiameter.SunDegrees) +
                       "\nThe feature sets the light's size: override Angular Diameter to see figures for another.";
            return PresetText.Figures(preset, lights[0]) +
                   string.Format(CultureInfo.InvariantCulture, "\nThe light is set by the feature: {0:0.##} degrees.",
                                 lights[0]);
        }

        // Presets do not set the light's size.
        private static List<string> Beside(PenumbraShadowsVolume volume) =>
            Labels(HasPreset(volume)
                       ? Overridden(volume).Where(option => option != OptionFields.AngularDiameter &&
                                                            option.Counts(Decided(volume)))
                       : Enumerable.Empty<OptionField>());

        private static List<string> Idle(PenumbraShadowsVolume volume, IReadOnlyCollection<ShadowOptions> inForce) =>
            Labels(Overridden(volume).Where(option => !inForce.Any(options => option.Counts(options))));

        private static IEnumerable<OptionField> Overridden(PenumbraShadowsVolume volume) =>
            OptionFields.All.Where(option => option.IsOverridden(volume));

        private static List<string> Labels(IEnumerable<OptionField> options) =>
            options.Select(option => option.label.text).ToList();

        private static string Techniques(IEnumerable<ShadowOptions> inForce) =>
            string.Join(" or ", inForce.Select(PresetText.Technique).Distinct());

        private static string Join(List<string> names, string verbOfOne, string verbOfMany)
        {
            if (names.Count == 1) return names[0] + " " + verbOfOne;
            return string.Join(", ", names.Take(names.Count - 1)) + " and " + names.Last() + " " + verbOfMany;
        }
    }
}
