using System;
using NUnit.Framework;
using Penumbra.Editor;

namespace Penumbra.Tests
{
    public sealed class PresetTextTests
    {
        [Test]
        public void EveryPresetHasItsFigures()
        {
            Assert.That(PresetFigures.Rows.Length, Is.EqualTo((int)QualityPreset.Custom));
            foreach (PresetFigure[] figures in PresetFigures.Rows)
                foreach (PresetFigure figure in figures)
                {
                    Assert.That(figure.penumbraRmse, Is.InRange(0.001f, 0.5f));
                    Assert.That(figure.fetches, Is.GreaterThanOrEqualTo(1.0f));
                }
        }

        [TestCase(0.0f, "0.53")]
        [TestCase(0.53f, "0.53")]
        [TestCase(1.0f, "0.53")]
        [TestCase(1.2f, "2")]
        [TestCase(30.0f, "5")]
        public void TheFiguresAreOfTheLightNearestInSize(float degrees, string measured) =>
            Assert.That(PresetText.Figures(QualityPreset.High, degrees),
                        Does.EndWith("measured under " + measured + " degrees."));

        [TestCase(QualityPreset.Low, "Tiled PCSS, 8 blocker and 16 filter samples, at half resolution; on devices that " +
                                     "cannot run it Bounded PCSS.")]
        [TestCase(QualityPreset.Reference, "Tiled PCSS, 128 blocker and 128 filter samples; on devices that cannot run it " +
                                           "Bounded PCSS.")]
        public void APresetIsSaidInWords(QualityPreset preset, string words) =>
            Assert.That(PresetText.Describe(ShadowPresets.Options(preset)), Is.EqualTo(words));

        [Test]
        public void OptionsOfOnesOwnAreSaidInWords()
        {
            ShadowOptions options = PresetFallback.Options(QualityPreset.High);
            options.denoise = true;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("PCSS, 32 blocker and 32 filter samples, where the mask finds a penumbra, denoised."));
            options.technique = ShadowTechnique.Tent5x5;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("Tent 5x5, 9 fetches of the shadow map, no contact hardening."));
            options = ShadowPresets.Options(QualityPreset.Ultra);
            options.mask = options.denoise = options.halfResolution = true;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("Tiled PCSS, 64 blocker and 64 filter samples, at half resolution; on devices that " +
                                   "cannot run it Bounded PCSS, where the mask finds a penumbra, denoised."));
            options.mask = false;
            options.technique = ShadowTechnique.PcssBounded;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("Bounded PCSS, 64 blocker and 64 filter samples, at half resolution, denoised."));
        }
    }
}
