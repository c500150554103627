using System;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEditor;
using UnityEngine;

namespace Penumbra.Tests
{
    public sealed class ShadowLooksTests
    {
        private static readonly ShadowLook[] Looks =
            Enum.GetValues(typeof(ShadowLook)).Cast<ShadowLook>().Where(look => look != ShadowLook.Custom).ToArray();

        private static PenumbraShadowsVolume Volume() => ScriptableObject.CreateInstance<PenumbraShadowsVolume>();

        private static LookFields Fields(SerializedObject feature, string of) =>
            new LookFields(feature.FindProperty(of + nameof(ShadowOptions.angularDiameterDegrees)),
                           feature.FindProperty(of + nameof(ShadowOptions.softnessCapMetres)));

        [TestCaseSource(nameof(Looks))]
        public void ALookIsToldByItsValues(ShadowLook look)
        {
            LookValues values = ShadowLooks.Values(look);
            Assert.That(ShadowLooks.Of(values.angularDiameterDegrees, values.softnessCapMetres), Is.EqualTo(look));
            Assert.That(ShadowLooks.Of(values.angularDiameterDegrees + 0.01f, values.softnessCapMetres),
                        Is.EqualTo(ShadowLook.Custom));
            Assert.That(ShadowLooks.Of(values.angularDiameterDegrees, values.softnessCapMetres - 0.5f),
                        Is.EqualTo(ShadowLook.Custom));
            Assert.That(values.title, Is.EqualTo(LookText.Names[(int)look]));
        }

        [Test]
        public void TheFeatureBeginsWithTheSunInClearAir() =>
            Assert.That(new PenumbraShadowsSettings().Look, Is.EqualTo(ShadowLook.CrispNoon));

        [TestCaseSource(nameof(Looks))]
        public void ALookChangesTheLightAndNothingOfTheQuality(ShadowLook look)
        {
            LookValues values = ShadowLooks.Values(look);
            foreach (QualityPreset preset in Enum.GetValues(typeof(QualityPreset)))
            {
                var settings = new PenumbraShadowsSettings { preset = preset };
                ShadowOptions expected = settings.Options();
                expected.angularDiameterDegrees = values.angularDiameterDegrees;
                expected.softnessCapMetres = values.softnessCapMetres;
                settings.Look = look;
                Assert.That(settings.Look, Is.EqualTo(look), preset.ToString());
                Assert.That(settings.Options(), Is.EqualTo(expected), preset.ToString());
            }
        }

        [Test]
        public void ALookOutlivesAChangeOfQuality()
        {
            var settings = new PenumbraShadowsSettings { Look = ShadowLook.Overcast };
            settings.preset = QualityPreset.Ultra;
            Assert.That(settings.Look, Is.EqualTo(ShadowLook.Overcast));
            Assert.That(settings.Options().softnessCapMetres,
                        Is.EqualTo(ShadowLooks.Values(ShadowLook.Overcast).softnessCapMetres));
        }

        [Test]
        public void CustomHasNoValues()
        {
            Assert.That(() => ShadowLooks.Values(ShadowLook.Custom), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => new PenumbraShadowsSettings { Look = ShadowLook.Custom },
                        Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => Volume().Override(ShadowLook.Custom), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(LookText.Describe(ShadowLook.Custom), Is.Null);
        }

        [TestCase("settings.")]
        [TestCase("settings.custom.")]
        public void AChoiceInTheFeaturesInspectorIsUndoneAtOnce(string of)
        {
            var feature = ScriptableObject.CreateInstance<PenumbraShadows>();
            var serialized = new SerializedObject(feature);
            LookFields fields = Fields(serialized, of);
            ShadowLook before = fields.Look;
            fields.Look = ShadowLook.Hazy;
            Assert.That(serialized.ApplyModifiedProperties());
            serialized.Update();
            Assert.That(fields.Look, Is.EqualTo(ShadowLook.Hazy));
            Undo.PerformUndo();
            serialized.Update();
            Assert.That(fields.Look, Is.EqualTo(before).And.Not.EqualTo(ShadowLook.Hazy));
        }

        [Test]
        public void AChoiceInAVolumesInspectorIsUndoneWithItsChecks()
        {
            PenumbraShadowsVolume volume = Volume();
            var serialized = new SerializedObject(volume);
            var look = new LookOverride(serialized);
            Assert.That(look.Look, Is.Null);
            look.Look = ShadowLook.Overcast;
            serialized.ApplyModifiedProperties();
            Assert.That(volume.angularDiameterDegrees.overrideState && volume.softnessCapMetres.overrideState);
            Assert.That(look.Look, Is.EqualTo(ShadowLook.Overcast));
            Undo.PerformUndo();
            serialized.Update();
            Assert.That(look.Look, Is.Null);
            Assert.That(volume.angularDiameterDegrees.value, Is.EqualTo(AngularDiameter.SunDegrees));
        }

        [Test]
        public void AVolumeThatLeavesTheLookKeepsItsOtherChecks()
        {
            PenumbraShadowsVolume volume = Volume();
            volume.Override(ShadowLook.Hazy);
            volume.mask.overrideState = true;
            var serialized = new SerializedObject(volume);
            new LookOverride(serialized).Look = null;
            serialized.ApplyModifiedProperties();
            Assert.That(volume.angularDiameterDegrees.overrideState || volume.softnessCapMetres.overrideState, Is.False);
            Assert.That(volume.mask.overrideState);
        }

        [Test]
        public void OneOfTheTwoValuesAloneIsNoLook()
        {
            PenumbraShadowsVolume volume = Volume();
            volume.angularDiameterDegrees.overrideState = true;
            Assert.That(new LookOverride(new SerializedObject(volume)).Look, Is.EqualTo(ShadowLook.Custom));
        }

        [Test]
        public void AVolumesLookHoldsUnderTheFeaturesPresetAndItsOwn()
        {
            ShadowOptions feature = new PenumbraShadowsSettings { preset = QualityPreset.High }.Options();
            PenumbraShadowsVolume volume = Volume();
            volume.Override(ShadowLook.Overcast);
            LookValues look = ShadowLooks.Values(ShadowLook.Overcast);
            ShadowOptions expected = feature.Under(look.angularDiameterDegrees, look.softnessCapMetres);
            Assert.That(volume.Over(feature), Is.EqualTo(expected));
            volume.preset.Set(QualityPreset.Low);
            expected = ShadowPresets.Options(QualityPreset.Low)
                .Under(look.angularDiameterDegrees, look.softnessCapMetres);
            Assert.That(volume.Over(feature), Is.EqualTo(expected));
        }

        [Test]
        public void AVolumesPresetKeepsTheFeaturesLook()
        {
            ShadowOptions feature = new PenumbraShadowsSettings { Look = ShadowLook.Overcast }.Options();
            PenumbraShadowsVolume volume = Volume();
            volume.preset.Set(QualityPreset.Ultra);
            ShadowOptions options = volume.Over(feature);
            Assert.That(ShadowLooks.Of(options.angularDiameterDegrees, options.softnessCapMetres),
                        Is.EqualTo(ShadowLook.Overcast));
        }

        // Volumes blend numbers in a straight line: on the way from one look to another a penumbra is never wider than
        // under the wider, nor narrower than under the narrower, and no chain of passes but the looks' is drawn.
        [Test]
        public void HalfwayBetweenTwoLooksIsAnOptionLikeAnyOther()
        {
            foreach (ShadowLook from in Looks)
                foreach (ShadowLook to in Looks)
                    for (float t = 0.0f; t <= 1.0f; t += 0.125f)
                    {
                        ShadowOptions a = Blended(from, from, 0.0f), b = Blended(to, to, 0.0f);
                        ShadowOptions options = Blended(from, to, t);
                        AssertBetween(options.angularDiameterDegrees, a.angularDiameterDegrees, b.angularDiameterDegrees);
                        AssertBetween(options.softnessCapMetres, a.softnessCapMetres, b.softnessCapMetres);
                        Assert.That(Passes(options), Is.EqualTo(Passes(a)).And.EqualTo(Passes(b)));
                    }
        }

        // A sum of floats ends beside its end by their rounding.
        private static void AssertBetween(float value, float a, float b)
        {
            float rounding = 4.0f * Mathf.Max(a, b) * 6e-8f;
            Assert.That(value, Is.InRange(Mathf.Min(a, b) - rounding, Mathf.Max(a, b) + rounding));
        }

        // VolumeParameter blends in this way: from + (to - from) * t.
        private static ShadowOptions Blended(ShadowLook from, ShadowLook to, float t)
        {
            LookValues a = ShadowLooks.Values(from), b = ShadowLooks.Values(to);
            PenumbraShadowsVolume volume = Volume();
            volume.Override(from);
            volume.angularDiameterDegrees.value =
                a.angularDiameterDegrees + (b.angularDiameterDegrees - a.angularDiameterDegrees) * t;
            volume.softnessCapMetres.value = a.softnessCapMetres + (b.softnessCapMetres - a.softnessCapMetres) * t;
            return volume.Over(ShadowPresets.Options(QualityPreset.High));
        }

        private static string[] Passes(ShadowOptions options) =>
            ShadowChain.Of(options).Steps.Select(step => step.pass.program).ToArray();

        [Test]
        public void AnInspectorSaysWhatALookStandsFor()
        {
            Assert.That(LookText.Describe(ShadowLook.Overcast), Does.EndWith(" Penumbrae are at most 2 m wide."));
            Assert.That(LookText.Describe(ShadowLook.CrispNoon), Does.Not.Contain("at most"));
            Assert.That(LookText.OfFigures(100.0f), Is.Null);
            Assert.That(LookText.OfFigures(2.0f), Does.Contain("without a softness cap"));
        }
    }
}
