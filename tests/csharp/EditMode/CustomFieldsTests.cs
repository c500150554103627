using System;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEditor;
using UnityEngine;

namespace Penumbra.Tests
{
    public sealed class CustomFieldsTests
    {
        private static readonly QualityPreset[] Presets = Enum.GetValues(typeof(QualityPreset)).Cast<QualityPreset>()
            .Where(preset => preset != QualityPreset.Custom).ToArray();

        private PenumbraShadows feature;
        private SerializedObject serialized;

        private PenumbraShadowsSettings Settings => feature.Settings;

        [SetUp]
        public void AFeatureWhoseCustomOptionsAreNoPresets()
        {
            feature = ScriptableObject.CreateInstance<PenumbraShadows>();
            serialized = new SerializedObject(feature);
            Settings.custom = new ShadowOptions
            {
                technique = ShadowTechnique.Tent3x3, angularDiameterDegrees = 7.0f, blockerSamples = 3, filterSamples = 5,
                softnessCapMetres = 9.0f, minFilterTexels = 4.0f, lightBleeding = 0.5f, mapBlurTexels = 2.0f,
                mapFormat = MapFormat.Bits16, rays = 2, samplesPerRay = 3, discRadiusMetres = 0.5f, mask = true,
                halfResolution = true, denoise = true,
            };
        }

        // The inspector does it in this order: the field changes, the values follow, both are applied together.
        private void Choose(QualityPreset preset)
        {
            serialized.Update();
            SerializedProperty settings = serialized.FindProperty("settings");
            settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.preset)).intValue = (int)preset;
            CustomFields.KeepPreset(settings, Settings);
            serialized.ApplyModifiedProperties();
        }

        private void Choose(ShadowTechnique technique)
        {
            serialized.Update();
            SerializedProperty settings = serialized.FindProperty("settings");
            settings.FindPropertyRelative(nameof(PenumbraShadowsSettings.custom))
                .FindPropertyRelative(nameof(ShadowOptions.technique)).intValue = (int)technique;
            CustomFields.BeginAsMeasured(settings, Settings);
            serialized.ApplyModifiedProperties();
        }

        [TestCaseSource(nameof(Presets))]
        public void CustomBeginsAsThePresetBeforeIt(QualityPreset preset)
        {
            Settings.preset = preset;
            Settings.Look = ShadowLook.Overcast;
            ShadowOptions before = Settings.Options();
            Choose(QualityPreset.Custom);
            Assert.That(Settings.preset, Is.EqualTo(QualityPreset.Custom));
            Assert.That(Settings.Options(), Is.EqualTo(before));
            Assert.That(Settings.Look, Is.EqualTo(ShadowLook.Overcast));
        }

        [Test]
        public void OneUndoBringsBackThePresetAndTheOptionsOfCustom()
        {
            Settings.preset = QualityPreset.Ultra;
            ShadowOptions custom = Settings.custom;
            Choose(QualityPreset.Custom);
            Assert.That(Settings.custom, Is.Not.EqualTo(custom));
            Undo.PerformUndo();
            Assert.That(Settings.preset, Is.EqualTo(QualityPreset.Ultra));
            Assert.That(Settings.custom, Is.EqualTo(custom));
        }

        [Test]
        public void CustomStaysAsItIsWhileItIsChosen()
        {
            Settings.preset = QualityPreset.Custom;
            ShadowOptions custom = Settings.custom;
            Choose(QualityPreset.Custom);
            Assert.That(Settings.custom, Is.EqualTo(custom));
        }

        [Test]
        public void AnotherPresetLeavesTheOptionsOfCustom()
        {
            Settings.preset = QualityPreset.Low;
            ShadowOptions custom = Settings.custom;
            Choose(QualityPreset.High);
            Assert.That(Settings.custom, Is.EqualTo(custom));
            Assert.That(Settings.Options(), Is.EqualTo(ShadowPresets.Options(QualityPreset.High)));
        }

        [Test]
        public void AnotherTechniqueBeginsAsItIsMeasured()
        {
            Settings.preset = QualityPreset.Custom;
            ShadowOptions expected = Settings.custom;
            Choose(ShadowTechnique.SingleLoop);
            expected.technique = ShadowTechnique.SingleLoop;
            expected.blockerSamples = 32;
            expected.discRadiusMetres = 0.05f;
            expected.minFilterTexels = 1.25f;
            Assert.That(Settings.custom, Is.EqualTo(expected), "the others stay");
            Undo.PerformUndo();
            Assert.That(Settings.custom.blockerSamples, Is.EqualTo(3));
        }

        [Test]
        public void AnotherTechniqueKeepsTheLook()
        {
            Settings.preset = QualityPreset.Custom;
            Choose(ShadowTechnique.Vssm);
            Assert.That(Settings.custom.angularDiameterDegrees, Is.EqualTo(7.0f));
            Assert.That(Settings.custom.softnessCapMetres, Is.EqualTo(9.0f));
            Assert.That(Settings.custom.minFilterTexels, Is.EqualTo(1.0f));
        }

        [Test]
        public void WhatIsSetAfterTheTechniqueStays()
        {
            Settings.preset = QualityPreset.Custom;
            Choose(ShadowTechnique.SingleLoop);
            Settings.custom.blockerSamples = 20;
            Choose(ShadowTechnique.SingleLoop);
            Assert.That(Settings.custom.blockerSamples, Is.EqualTo(20));
        }
    }
}
