using System;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEditor;
using UnityEngine;

namespace Penumbra.Tests
{
    public sealed class VolumeAdviceTests
    {
        private static VolumeState State(Action<PenumbraShadowsVolume> change, params PenumbraShadowsSettings[] features)
        {
            var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
            change(volume);
            return new VolumeState { volume = volume, features = features };
        }

        private static PenumbraShadowsSettings Feature(QualityPreset preset, float degrees = 0.53f) =>
            new PenumbraShadowsSettings { preset = preset, angularDiameterDegrees = degrees };

        private static PenumbraShadowsSettings Feature(ShadowTechnique technique)
        {
            var settings = new PenumbraShadowsSettings { preset = QualityPreset.Custom };
            settings.custom.technique = technique;
            return settings;
        }

        private static void Nothing(PenumbraShadowsVolume volume) { }

        private static Action<PenumbraShadowsVolume> Preset(QualityPreset preset) =>
            volume => volume.preset.Set(preset);

        private static Action<PenumbraShadowsVolume> Technique(ShadowTechnique technique) =>
            volume => volume.technique.Set(technique);

        private static Action<PenumbraShadowsVolume> Angle(float degrees) =>
            volume => volume.angularDiameterDegrees.Set(degrees);

        private static void Denoise(PenumbraShadowsVolume volume) => volume.denoise.overrideState = true;

        private static void Mask(PenumbraShadowsVolume volume) => volume.mask.overrideState = true;

        private static void HalfResolution(PenumbraShadowsVolume volume) => volume.halfResolution.overrideState = true;

        private static void LightBleeding(PenumbraShadowsVolume volume) => volume.lightBleeding.overrideState = true;

        private static void Samples(PenumbraShadowsVolume volume) => volume.filterSamples.overrideState = true;

        private static string[] Texts(VolumeState state) => VolumeAdvice.For(state).Select(advice => advice.text).ToArray();

        private static string[] Shown(VolumeState state) =>
            OptionFields.All.Where(option => VolumeAdvice.Shows(option, state.volume)).Select(option => option.label.text)
                .ToArray();

        [Test]
        public void AVolumeThatOverridesNothingShowsEverythingItCan()
        {
            VolumeState state = State(Nothing, Feature(QualityPreset.Low));
            Assert.That(Shown(state), Is.EqualTo(OptionFields.All.Where(option => option.IsInVolume)
                                                     .Select(option => option.label.text)));
            Assert.That(VolumeAdvice.Preset(state), Is.Null);
            Assert.That(Texts(state), Is.Empty);
        }

        [Test]
        public void OnlyWhatCountsForTheTechniqueIsShown()
        {
            string[] ofTents = { "Technique", "Half Resolution" };
            Assert.That(Shown(State(Technique(ShadowTechnique.Tent7x7))), Is.EqualTo(ofTents));
            Assert.That(Shown(State(Preset(QualityPreset.Low))),
                        Is.EqualTo(new[]
                        {
                            "Technique", "Angular Diameter", "Blocker Samples", "Filter Samples", "Softness Cap",
                            "Half Resolution",
                        }));
            Assert.That(Shown(State(Technique(ShadowTechnique.PcssBounded))), Does.Contain("Mask").And.Contain("Denoise"));
            Assert.That(Shown(State(Technique(ShadowTechnique.PcssHdrp))), Does.Not.Contain("Softness Cap"));
            Assert.That(Shown(State(Technique(ShadowTechnique.PcssPoisson))), Does.Not.Contain("Filter Samples"));
            Assert.That(Shown(State(Angle(0.0f))), Does.Not.Contain("Denoise"));
        }

        [Test]
        public void OfFilteredMapsTheirOwnOptionsAreShown()
        {
            Assert.That(Shown(State(Technique(ShadowTechnique.Vsm))),
                        Is.EqualTo(new[]
                        {
                            "Technique", "Light Bleeding Reduction", "Map Blur", "Map Format", "Half Resolution",
                        }));
            Assert.That(Shown(State(Technique(ShadowTechnique.Vssm))),
                        Is.EqualTo(new[]
                        {
                            "Technique", "Angular Diameter", "Softness Cap", "Light Bleeding Reduction", "Half Resolution",
                        }));
            Assert.That(Shown(State(Technique(ShadowTechnique.Smrt))),
                        Is.EqualTo(new[]
                        {
                            "Technique", "Angular Diameter", "Rays", "Samples Per Ray", "Softness Cap", "Mask",
                            "Half Resolution", "Denoise",
                        }));
        }

        [Test]
        public void TheTechniqueComesAfterThePreset() =>
            Assert.That(Shown(State(Preset(QualityPreset.Reference) + Technique(ShadowTechnique.Tent7x7))),
                        Does.Not.Contain("Filter Samples"));

        [Test]
        public void AnOverriddenOptionStaysShownSoThatItsCheckCanBeCleared() =>
            Assert.That(Shown(State(Technique(ShadowTechnique.Tent5x5) + Denoise)), Does.Contain("Denoise"));

        [Test]
        public void APresetHasItsFiguresUnderTheVolumesLight()
        {
            VolumeState state = State(Preset(QualityPreset.High) + Angle(4.0f), Feature(QualityPreset.Low, 0.53f));
            Assert.That(VolumeAdvice.Preset(state),
                        Is.EqualTo(PresetText.Describe(ShadowPresets.Options(QualityPreset.High)) + "\n" +
                                   PresetText.Figures(QualityPreset.High, 4.0f)));
        }

        [Test]
        public void ElseUnderTheFeaturesLightAndSaysSo()
        {
            string text = VolumeAdvice.Preset(State(Preset(QualityPreset.High), Feature(QualityPreset.Low, 1.5f)));
            Assert.That(text, Does.Contain(PresetText.Figures(QualityPreset.High, 1.5f)).And.EndWith("by the feature: 1.5 degrees."));
        }

        [Test]
        public void ElseUnderTheSunAndSaysSo()
        {
            string figures = PresetText.Figures(QualityPreset.High, 0.53f);
            var two = new[] { Feature(QualityPreset.Low, 1.5f), Feature(QualityPreset.Low, 5.0f) };
            foreach (VolumeState state in new[] { State(Preset(QualityPreset.High)), State(Preset(QualityPreset.High), two) })
                Assert.That(VolumeAdvice.Preset(state), Does.Contain(figures + "\n").And.Contain("Angular Diameter"));
        }

        [Test]
        public void CustomHasNoFiguresAndChangesNothingByItself()
        {
            VolumeState state = State(Preset(QualityPreset.Custom), Feature(QualityPreset.Medium));
            Assert.That(VolumeAdvice.Preset(state), Is.Null);
            Assert.That(Texts(state).Single(), Does.StartWith("Custom changes nothing"));
            ShadowOptions options = ShadowPresets.Options(QualityPreset.Ultra);
            Assert.That(state.volume.Over(options), Is.EqualTo(options));
        }

        [Test]
        public void WithoutAFeatureAVolumeIsWarnedOf()
        {
            Advice advice = VolumeAdvice.For(State(Nothing)).Single();
            Assert.That(advice.type, Is.EqualTo(MessageType.Warning));
            Assert.That(advice.text, Does.Contain("Add Renderer Feature > Penumbra Soft Shadows"));
        }

        [Test]
        public void OptionsBesideAPresetEndItsFigures()
        {
            PenumbraShadowsSettings feature = Feature(QualityPreset.Medium);
            Assert.That(Texts(State(Preset(QualityPreset.High) + HalfResolution, feature)).Single(),
                        Does.StartWith("Half Resolution overrides the preset"));
            Assert.That(Texts(State(Preset(QualityPreset.Reference) + Samples, feature)).Single(),
                        Does.StartWith("Filter Samples overrides the preset"));
            Assert.That(Texts(State(Preset(QualityPreset.Reference) + HalfResolution + Samples, feature)).Single(),
                        Does.StartWith("Filter Samples and Half Resolution override the preset"));
        }

        /// <summary>Options of the fallback do not end the preset's figures, which are Tiled PCSS's.</summary>
        [Test]
        public void OptionsOfWhatStandsInForAPresetAreNamed()
        {
            PenumbraShadowsSettings feature = Feature(QualityPreset.Medium);
            Assert.That(Texts(State(Preset(QualityPreset.High) + Denoise + Mask, feature)).Single(),
                        Is.EqualTo("Mask and Denoise have no effect with Tiled PCSS, only with Bounded PCSS on devices " +
                                   "that cannot run Tiled PCSS."));
            Assert.That(Texts(State(Preset(QualityPreset.High) + Denoise + LightBleeding, feature)),
                        Is.EqualTo(new[]
                        {
                            "Light Bleeding Reduction has no effect with Tiled PCSS. Clear the checkbox, or change the " +
                            "technique or preset.",
                            "Denoise has no effect with Tiled PCSS, only with Bounded PCSS on devices that cannot run " +
                            "Tiled PCSS.",
                        }));
            Assert.That(Texts(State(Preset(QualityPreset.High) + Denoise + Angle(0.0f), feature)).Single(),
                        Does.StartWith("Denoise has no effect with Tiled PCSS. "), "nor with what stands in at 0 degrees");
        }

        [Test]
        public void TheLightIsNoPartOfAPreset() =>
            Assert.That(Texts(State(Preset(QualityPreset.High) + Angle(2.0f), Feature(QualityPreset.Medium))), Is.Empty);

        [Test]
        public void OptionsWithoutAPresetAreNobodysFigures() =>
            Assert.That(Texts(State(Denoise, Feature(ShadowTechnique.Pcss))), Is.Empty);

        [Test]
        public void WhatHasNoEffectIsNamedWithTheTechnique()
        {
            PenumbraShadowsSettings feature = Feature(QualityPreset.Medium);
            Assert.That(Texts(State(Technique(ShadowTechnique.Tent3x3) + Denoise + Samples + Angle(2.0f), feature)).Single(),
                        Does.StartWith("Angular Diameter, Filter Samples and Denoise have no effect with Tent 3x3."));
            Assert.That(Texts(State(Technique(ShadowTechnique.Tent5x5) + Denoise, feature)).Single(),
                        Does.StartWith("Denoise has no effect with Tent 5x5."));
            Assert.That(Texts(State(Angle(0.0f) + Denoise, feature)).Single(),
                        Does.StartWith("Denoise has no effect with PCSS at 0 degrees."));
        }

        [Test]
        public void WhatHasNoEffectWithTheFeaturesTechniqueIsNamed()
        {
            Assert.That(Texts(State(Denoise, Feature(ShadowTechnique.Tent5x5))).Single(),
                        Does.StartWith("Denoise has no effect with Tent 5x5, which the feature selects."));
            Assert.That(Texts(State(Denoise, Feature(ShadowTechnique.Tent5x5), Feature(ShadowTechnique.Pcss))), Is.Empty);
            Assert.That(Texts(State(Denoise, Feature(ShadowTechnique.Tent5x5), Feature(QualityPreset.High))).Single(),
                        Is.EqualTo("Denoise has no effect with Tent 5x5 or Tiled PCSS, which the feature selects, only with " +
                                   "Bounded PCSS on devices that cannot run Tiled PCSS."));
        }

        [Test]
        public void TheDefaultProfileOverridesNothing()
        {
            VolumeState state = State(Preset(QualityPreset.Low) + Denoise);
            state.defaultProfile = true;
            Assert.That(VolumeAdvice.Preset(state), Is.Null);
            Assert.That(Texts(state).Single(), Does.StartWith("The default profile"));
        }

        [Test]
        public void TheWorstComesFirst() =>
            Assert.That(VolumeAdvice.For(State(Preset(QualityPreset.Low) + Denoise)).Select(advice => advice.type),
                        Is.EqualTo(new[] { MessageType.Warning, MessageType.Info }));
    }
}
