using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Tests
{
    public sealed class ShadowOptionsTests
    {
        private static ShadowOptions Odd(float number, int count) => new ShadowOptions
        {
            technique = ShadowTechnique.Pcss, angularDiameterDegrees = number, softnessCapMetres = number,
            minFilterTexels = number, blockerSamples = count, filterSamples = count, lightBleeding = number,
            mapBlurTexels = number, discRadiusMetres = number, rays = count, samplesPerRay = count,
            filterCells = count,
        };

        [TestCase(float.NaN, int.MinValue)]
        [TestCase(float.PositiveInfinity, int.MaxValue)]
        [TestCase(float.NegativeInfinity, 0)]
        [TestCase(-1.0f, -1)]
        [TestCase(1e30f, 1000)]
        public void ClampedIsWithinEveryRange(float number, int count)
        {
            ShadowOptions options = Odd(number, count).Clamped();
            Assert.That(options.angularDiameterDegrees, Is.InRange(0.0f, 30.0f));
            Assert.That(options.softnessCapMetres, Is.InRange(0.0f, 100.0f));
            Assert.That(options.minFilterTexels, Is.InRange(0.0f, 8.0f));
            Assert.That(options.blockerSamples, Is.InRange(1, 64));
            Assert.That(options.filterSamples, Is.InRange(1, 64));
            Assert.That(options.rays, Is.InRange(1, 64));
            Assert.That(options.samplesPerRay, Is.InRange(1, 64));
            Assert.That(options.filterCells, Is.InRange(3, 5));
            Assert.That(options.lightBleeding, Is.InRange(0.0f, 0.95f));
            Assert.That(options.mapBlurTexels, Is.InRange(0.0f, 4.0f));
            Assert.That(options.discRadiusMetres, Is.InRange(0.0f, 1.0f));
            Assert.That(options.Clamped(), Is.EqualTo(options));
        }

        [Test]
        public void PresetsAreWithinEveryRangeAndDiffer()
        {
            foreach (QualityPreset a in Enum.GetValues(typeof(QualityPreset)))
            {
                ShadowOptions options = ShadowPresets.Options(a);
                Assert.That(options.Clamped(), Is.EqualTo(options), a.ToString());
                foreach (QualityPreset b in Enum.GetValues(typeof(QualityPreset)))
                    if (a < b && b != QualityPreset.Custom)
                        Assert.That(ShadowPresets.Options(b), Is.Not.EqualTo(options), a + " and " + b);
            }
        }

        [Test]
        public void EqualityLooksAtEveryField()
        {
            object original = ShadowPresets.Options(QualityPreset.High);
            foreach (System.Reflection.FieldInfo field in typeof(ShadowOptions).GetFields())
            {
                object changed = ShadowPresets.Options(QualityPreset.High);
                object value = field.GetValue(changed);
                field.SetValue(changed, value is bool on ? !on
                                        : value is float number ? number + 1.0f
                                        : value is int count ? count + 1
                                        : value is MapFormat ? MapFormat.Bits16
                                        : value is DebugView ? DebugView.Cascades
                                        : value is FarShadowMode ? FarShadowMode.HorizonAngles
                                        : (object)ShadowTechnique.Tent3x3);
                Assert.That(changed, Is.Not.EqualTo(original), field.Name);
            }
        }

        [Test]
        public void TheFeaturesAngleHoldsForEveryPresetButCustom()
        {
            var settings = new PenumbraShadowsSettings { angularDiameterDegrees = 2.0f };
            settings.custom.angularDiameterDegrees = 5.0f;
            Assert.That(settings.Options().angularDiameterDegrees, Is.EqualTo(2.0f));
            settings.preset = QualityPreset.Custom;
            Assert.That(settings.Options().angularDiameterDegrees, Is.EqualTo(5.0f));
        }

        [Test]
        public void HdrpKeepsHdrpsLimits()
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.High);
            options.technique = ShadowTechnique.PcssHdrp;
            SoftShadowParameters parameters = options.Parameters();
            Assert.That(parameters.MaxPenumbraMetres, Is.EqualTo(0.56f));
            Assert.That(parameters.BlockerSamples, Is.EqualTo(options.blockerSamples));
        }
    }

    public sealed class PenumbraShadowsVolumeTests
    {
        private static PenumbraShadowsVolume Volume() => ScriptableObject.CreateInstance<PenumbraShadowsVolume>();

        private static readonly ShadowOptions Feature = ShadowPresets.Options(QualityPreset.High);

        [Test]
        public void AVolumeThatOverridesNothingChangesNothing() =>
            Assert.That(Volume().Over(Feature), Is.EqualTo(Feature));

        [Test]
        public void APresetComesBeforeTheSingleValues()
        {
            PenumbraShadowsVolume volume = Volume();
            volume.preset.overrideState = true;
            volume.preset.value = QualityPreset.Low;
            volume.filterSamples.overrideState = true;
            volume.filterSamples.value = 5;
            ShadowOptions expected = ShadowPresets.Options(QualityPreset.Low);
            expected.filterSamples = 5;
            Assert.That(volume.Over(Feature), Is.EqualTo(expected));
        }

        [Test]
        public void APresetKeepsTheLightsSize()
        {
            ShadowOptions feature = Feature;
            feature.angularDiameterDegrees = 3.0f;
            PenumbraShadowsVolume volume = Volume();
            volume.preset.overrideState = true;
            Assert.That(volume.Over(feature).angularDiameterDegrees, Is.EqualTo(3.0f));
        }

        [Test]
        public void EveryParameterReachesItsOption()
        {
            PenumbraShadowsVolume volume = Volume();
            volume.angularDiameterDegrees.overrideState = true;
            volume.angularDiameterDegrees.value = 4.0f;
            volume.technique.overrideState = true;
            volume.technique.value = ShadowTechnique.PcssPoisson;
            volume.blockerSamples.overrideState = true;
            volume.blockerSamples.value = 33;
            volume.softnessCapMetres.overrideState = true;
            volume.softnessCapMetres.value = 0.5f;
            volume.lightBleeding.overrideState = true;
            volume.lightBleeding.value = 0.4f;
            volume.mapBlurTexels.overrideState = true;
            volume.mapBlurTexels.value = 3.0f;
            volume.mapFormat.overrideState = true;
            volume.mapFormat.value = MapFormat.Bits16;
            volume.rays.overrideState = true;
            volume.rays.value = 5;
            volume.samplesPerRay.overrideState = true;
            volume.samplesPerRay.value = 6;
            volume.discRadiusMetres.overrideState = true;
            volume.discRadiusMetres.value = 0.25f;
            volume.filterCells.overrideState = true;
            volume.filterCells.value = 4;
            volume.mask.overrideState = true;
            volume.mask.value = false;
            volume.conservativeMask.overrideState = true;
            volume.conservativeMask.value = true;
            volume.halfResolution.overrideState = true;
            volume.halfResolution.value = true;
            volume.denoise.overrideState = true;
            volume.denoise.value = false;
            volume.contactShadowMetres.overrideState = true;
            volume.contactShadowMetres.value = 0.125f;
            volume.contactShadowSteps.overrideState = true;
            volume.contactShadowSteps.value = 20;
            ShadowOptions options = volume.Over(Feature);
            Assert.That(options, Is.EqualTo(new ShadowOptions
            {
                technique = ShadowTechnique.PcssPoisson, angularDiameterDegrees = 4.0f, blockerSamples = 33,
                filterSamples = Feature.filterSamples, softnessCapMetres = 0.5f,
                minFilterTexels = Feature.minFilterTexels, lightBleeding = 0.4f, mapBlurTexels = 3.0f,
                mapFormat = MapFormat.Bits16, rays = 5, samplesPerRay = 6, discRadiusMetres = 0.25f, filterCells = 4,
                mask = false, conservativeMask = true, halfResolution = true, denoise = false,
                contactShadowMetres = 0.125f, contactShadowSteps = 20,
            }));
        }

        // These are options that only other techniques than the presets' have.
        private static float[] NumbersOfOthers(in ShadowOptions options) => new[]
        {
            options.lightBleeding, options.mapBlurTexels, options.rays, options.samplesPerRay, options.discRadiusMetres,
        };

        [Test]
        public void NumbersOfOtherTechniquesBeginAsTheseAreMeasured()
        {
            ShadowOptions measured = default;
            ShadowTechnique.Vsm.Entry().SetMeasured(ref measured);
            ShadowTechnique.Smrt.Entry().SetMeasured(ref measured);
            ShadowTechnique.SingleLoop.Entry().SetMeasured(ref measured);
            Assert.That(NumbersOfOthers(measured), Has.None.Zero);
            var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
            foreach (VolumeParameter parameter in new VolumeParameter[]
                     {
                         volume.lightBleeding, volume.mapBlurTexels, volume.rays, volume.samplesPerRay,
                         volume.discRadiusMetres,
                     })
                parameter.overrideState = true;
            Assert.That(NumbersOfOthers(volume.Over(default)), Is.EqualTo(NumbersOfOthers(measured)));
            foreach (QualityPreset preset in new[] { QualityPreset.Low, QualityPreset.High, QualityPreset.Reference })
                Assert.That(NumbersOfOthers(ShadowPresets.Options(preset)), Is.EqualTo(NumbersOfOthers(measured)));
        }
    }
}
