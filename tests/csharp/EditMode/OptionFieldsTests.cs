using System;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEngine;
using UnityEngine.Rendering;
using RangeAttribute = UnityEngine.RangeAttribute;

namespace Penumbra.Tests
{
    public sealed class OptionFieldsTests
    {
        private static readonly FieldInfo[] Fields =
            typeof(ShadowOptions).GetFields(BindingFlags.Instance | BindingFlags.Public);

        private static ShadowOptions Options(ShadowTechnique technique, float degrees)
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.High);
            options.technique = technique;
            options.angularDiameterDegrees = degrees;
            return options;
        }

        private static ShadowOptions With(ShadowOptions options, string field, object value)
        {
            object boxed = options;
            typeof(ShadowOptions).GetField(field).SetValue(boxed, value);
            return (ShadowOptions)boxed;
        }

        private static string[] Draws(ShadowOptions options) =>
            ShadowChain.Of(options).Steps.Select(step => step.pass.program).ToArray();

        // Whether frames are averaged is a choice of the feature's Noise.
        [Test]
        public void EveryOptionIsShownOnceWithItsLabelAndTooltip()
        {
            OptionField[] all = OptionFields.All.Append(OptionFields.CascadeBlend).Append(OptionFields.ContactShadows)
                .Append(OptionFields.ContactShadowSteps).Append(OptionFields.FarShadows).Append(OptionFields.Clouds)
                .Append(OptionFields.DebugView).ToArray();
            Assert.That(all.Select(option => option.name), Is.EquivalentTo(Fields.Select(field => field.Name)
                                                                                 .Except(new[] { nameof(ShadowOptions.accumulates) })));
            Assert.That(all.Select(option => option.label.text), Is.Unique);
            foreach (OptionField option in all) Assert.That(option.label.tooltip, Does.EndWith("."), option.name);
        }

        [Test]
        public void ATooltipNamesTheRange()
        {
            foreach (OptionField option in OptionFields.All)
            {
                var range = typeof(ShadowOptions).GetField(option.name).GetCustomAttribute<RangeAttribute>();
                if (range != null)
                    Assert.That(option.label.tooltip, Does.Contain(range.min + " to " + range.max), option.name);
            }
        }

        [Test]
        public void TheVolumesParameterHasTheOptionsName()
        {
            foreach (OptionField option in OptionFields.All.Where(option => option.IsInVolume))
            {
                var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
                FieldInfo field = typeof(PenumbraShadowsVolume).GetField(option.name);
                Assert.That(field, Is.Not.Null, option.name);
                Assert.That(option.IsOverridden(volume), Is.False, option.name);
                ((VolumeParameter)field.GetValue(volume)).overrideState = true;
                Assert.That(OptionFields.All.Where(other => other.IsOverridden(volume)), Is.EqualTo(new[] { option }));
            }
        }

        // The inspectors' sliders end where the options are clamped.
        [Test]
        public void RangesAreThoseOfClamped()
        {
            var ranged = Fields.Where(field => field.FieldType == typeof(int) || field.FieldType == typeof(float));
            foreach (FieldInfo field in ranged)
            {
                var range = field.GetCustomAttribute<RangeAttribute>();
                Assert.That(range, Is.Not.Null, field.Name);
                foreach (float end in new[] { range.min, range.max })
                {
                    object beyond = Convert.ChangeType(end + (end == range.min ? -1.0f : 1.0f), field.FieldType);
                    ShadowOptions clamped = With(Options(ShadowTechnique.Pcss, 2.0f), field.Name, beyond).Clamped();
                    Assert.That(field.GetValue(clamped), Is.EqualTo(end), field.Name);
                }
                object parameter = typeof(PenumbraShadowsVolume).GetField(field.Name)
                    ?.GetValue(ScriptableObject.CreateInstance<PenumbraShadowsVolume>());
                if (parameter is ClampedIntParameter count)
                    Assert.That((count.min, count.max), Is.EqualTo(((int)range.min, (int)range.max)), field.Name);
                if (parameter is ClampedFloatParameter number)
                    Assert.That((number.min, number.max), Is.EqualTo((range.min, range.max)), field.Name);
            }
        }

        [Test]
        public void WhatTheFramesDrawsAreMadeOfCountsWhereItChangesThem()
        {
            foreach (ShadowTechnique technique in Enum.GetValues(typeof(ShadowTechnique)))
                foreach (float degrees in new[] { 0.0f, 2.0f })
                    foreach (OptionField option in new[] { OptionFields.Mask, OptionFields.ConservativeMask,
                                                           OptionFields.HalfResolution, OptionFields.Denoise })
                    {
                        ShadowOptions options = Options(technique, degrees);
                        bool changes = !Draws(With(options, option.name, true))
                            .SequenceEqual(Draws(With(options, option.name, false)));
                        Assert.That(option.Counts(options), Is.EqualTo(changes), option.name + " " + technique);
                    }
        }

        // The search of classic PCSS has no cap, but its mask widens no farther than the cap.
        [TestCase(true)]
        [TestCase(false)]
        public void ClassicPcssHasACapThroughItsMask(bool mask)
        {
            ShadowOptions options = Options(ShadowTechnique.PcssPoisson, 2.0f);
            options.mask = mask;
            Assert.That(OptionFields.SoftnessCap.Counts(options), Is.EqualTo(mask));
        }

        [Test]
        public void AHardShadowHasNoWidthToCap() =>
            Assert.That(OptionFields.SoftnessCap.Counts(Options(ShadowTechnique.Pcss, 0.0f)), Is.False);

        [Test]
        public void TheAngleCountsEvenAtZero() =>
            Assert.That(OptionFields.AngularDiameter.Counts(Options(ShadowTechnique.Pcss, 0.0f)));
    }
}
