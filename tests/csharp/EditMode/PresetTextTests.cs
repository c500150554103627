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

        [TestCase(QualityPreset.Low, "PCSS, 6 blocker and 8 filter samples.")]
        [TestCase(QualityPreset.Ultra, "PCSS, 16 blocker and 32 filter samples, where the mask finds a penumbra.")]
        [TestCase(QualityPreset.Reference, "PCSS, 64 blocker and 64 filter samples.")]
        public void APresetIsSaidInWords(QualityPreset preset, string words) =>
            Assert.That(PresetText.Describe(ShadowPresets.Options(preset)), Is.EqualTo(words));

        [Test]
        public void OptionsOfOnesOwnAreSaidInWords()
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.High);
            options.denoise = true;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("PCSS, 12 blocker and 24 filter samples, where the mask finds a penumbra, denoised."));
            options = ShadowPresets.Options(QualityPreset.Low);
            options.technique = ShadowTechnique.Tent5x5;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("Tent 5x5, 9 fetches of the shadow map, no contact hardening."));
            options = ShadowPresets.Options(QualityPreset.Ultra);
            options.technique = ShadowTechnique.Flagship;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("Flagship, all texels around a pixel in place of samples; where the device cannot run " +
                                   "it PCSS, 16 blocker and 32 filter samples."));
            options.halfResolution = true;
            Assert.That(PresetText.Describe(options), Does.EndWith("32 filter samples, at half resolution."));
            options.technique = ShadowTechnique.FlagshipPixel;
            Assert.That(PresetText.Describe(options),
                        Is.EqualTo("Flagship, per pixel, all texels around a pixel in place of samples, at half resolution."));
        }
    }
}
