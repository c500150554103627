using System;
using System.Reflection;
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
            Assert.That(options.blockerSamples, Is.InRange(1, 128));
            Assert.That(options.filterSamples, Is.InRange(1, 128));
            Assert.That(options.rays, Is.InRange(1, 64));
            Assert.That(options.samplesPerRay, Is.InRange(1, 64));
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

        /// <summary>Another value of an option, within its range.</summary>
        internal static object Changed(object value) =>
            value is bool on ? !on
            : value is float number ? number > 0.25f ? 0.75f * number : number + 0.125f
            : value is int count ? count > 4 ? count - 1 : count + 1
            : value is MapFormat ? MapFormat.Bits16
            : value is DebugView ? DebugView.Cascades
            : value is FarShadowMode ? FarShadowMode.HorizonAngles
            : (object)ShadowTechnique.Tent3x3;

        [Test]
        public void EqualityLooksAtEveryField()
        {
            object original = ShadowPresets.Options(QualityPreset.High);
            foreach (FieldInfo field in typeof(ShadowOptions).GetFields())
            {
                object changed = ShadowPresets.Options(QualityPreset.High);
                field.SetValue(changed, Changed(field.GetValue(changed)));
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
            volume.preset.Set(QualityPreset.Low);
            volume.filterSamples.Set(5);
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
        public void EveryParameterReachesItsOptionAlone()
        {
            foreach (FieldInfo parameter in typeof(PenumbraShadowsVolume).GetFields())
            {
                if (!typeof(VolumeParameter).IsAssignableFrom(parameter.FieldType) || parameter.Name == "preset") continue;
                PenumbraShadowsVolume volume = Volume();
                FieldInfo option = typeof(ShadowOptions).GetField(parameter.Name);
                Assert.That(option, Is.Not.Null, parameter.Name);
                object expected = Feature, value = ShadowOptionsTests.Changed(option.GetValue(Feature));
                option.SetValue(expected, value);
                var overridden = (VolumeParameter)parameter.GetValue(volume);
                overridden.overrideState = true;
                overridden.GetType().GetProperty("value").SetValue(overridden, value);
                Assert.That(volume.Over(Feature), Is.EqualTo(((ShadowOptions)expected).Clamped()), parameter.Name);
                Assert.That(expected, Is.Not.EqualTo(Feature), parameter.Name);
            }
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
