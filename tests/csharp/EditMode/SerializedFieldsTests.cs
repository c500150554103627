using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEngine;
using UnityEngine.Rendering;
using RangeAttribute = UnityEngine.RangeAttribute;

namespace Penumbra.Tests
{
    /// <summary>
    /// Every field that an inspector can show of the package says what it is, in which unit and within what range.
    /// </summary>
    public sealed class SerializedFieldsTests
    {
        private static readonly Type[] Owners =
        {
            typeof(PenumbraShadows), typeof(PenumbraShadowsSettings), typeof(ShadowOptions), typeof(PenumbraShadowsVolume),
            typeof(PassAssets), typeof(FarShadowsSettings), typeof(FarShadowGround),
        };

        private static IEnumerable<FieldInfo> Serialized() =>
            from owner in Owners
            from field in owner.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic |
                                          BindingFlags.DeclaredOnly)
            where IsSerialized(field) && !field.IsInitOnly
            where field.IsPublic || field.GetCustomAttribute<SerializeField>() != null
            select field;

        private static bool IsSerialized(FieldInfo field) => field.GetCustomAttribute<NonSerializedAttribute>() == null;

        private static string Tooltip(MemberInfo field) => field.GetCustomAttribute<TooltipAttribute>()?.tooltip;

        [Test]
        public void EveryOneHasATooltip()
        {
            Assert.That(Serialized().Count(), Is.GreaterThan(25));
            foreach (FieldInfo field in Serialized())
                Assert.That(Tooltip(field), Is.Not.Null.And.EndsWith("."), field.DeclaringType.Name + "." + field.Name);
        }

        // The unit is the last word of a field's name, or of what it counts.
        [TestCase("Degrees", "degrees")]
        [TestCase("Metres", "metres")]
        [TestCase("Texels", "texels")]
        [TestCase("Samples", "fetches")]
        public void ANumbersTooltipSaysUnitAndRange(string name, string unit)
        {
            FieldInfo[] fields = Serialized().Where(field => field.Name.EndsWith(name) && IsNumber(field)).ToArray();
            Assert.That(fields, Is.Not.Empty);
            foreach (FieldInfo field in fields)
            {
                Assert.That(Tooltip(field), Does.Contain(unit), field.Name);
                (float min, float max) = Range(field);
                Assert.That(Tooltip(field), Does.Contain(min + " to " + max), field.Name);
            }
        }

        [Test]
        public void EveryNumberHasARange()
        {
            foreach (FieldInfo field in Serialized().Where(IsNumber))
                Assert.That(Range(field).max, Is.GreaterThan(Range(field).min), field.Name);
        }

        private static bool IsNumber(FieldInfo field) =>
            field.FieldType == typeof(float) || field.FieldType == typeof(int) ||
            typeof(FloatParameter).IsAssignableFrom(field.FieldType) || typeof(IntParameter).IsAssignableFrom(field.FieldType);

        private static (float min, float max) Range(FieldInfo field)
        {
            if (field.DeclaringType != typeof(PenumbraShadowsVolume))
            {
                var range = field.GetCustomAttribute<RangeAttribute>();
                return range == null ? default : (range.min, range.max);
            }
            object parameter = field.GetValue(ScriptableObject.CreateInstance<PenumbraShadowsVolume>());
            if (parameter is ClampedIntParameter count) return (count.min, count.max);
            return parameter is ClampedFloatParameter number ? (number.min, number.max) : default;
        }

        [Test]
        public void AVolumeSaysWhatTheFeatureSays()
        {
            foreach (FieldInfo field in Serialized().Where(field => field.DeclaringType == typeof(PenumbraShadowsVolume)))
            {
                FieldInfo option = typeof(ShadowOptions).GetField(field.Name);
                if (option != null && IsSerialized(option)) Assert.That(Tooltip(field), Is.EqualTo(Tooltip(option)));
            }
            foreach (OptionField option in OptionFields.All)
                Assert.That(option.label.tooltip, Is.EqualTo(Tooltip(typeof(ShadowOptions).GetField(option.name))));
        }

        [TestCase(ShadowTechnique.Tent5x5, "Tent 5x5")]
        [TestCase(ShadowTechnique.Pcss, "PCSS")]
        [TestCase(ShadowTechnique.PcssPoisson, "PCSS (Poisson)")]
        [TestCase(ShadowTechnique.PcssHdrp, "PCSS (HDRP)")]
        public void ATechniqueIsCalledAsItsListCallsIt(ShadowTechnique technique, string name) =>
            Assert.That(TechniqueName.Of(technique), Is.EqualTo(name));

        [Test]
        public void EveryTechniqueAndLookHasItsName()
        {
            foreach (ShadowTechnique technique in Enum.GetValues(typeof(ShadowTechnique)))
                Assert.That(TechniqueName.Of(technique), Is.Not.Empty);
            foreach (LookValues look in LookTable.Rows)
            {
                FieldInfo value = typeof(ShadowLook).GetField(
                    ShadowLooks.Of(look.angularDiameterDegrees, look.softnessCapMetres).ToString());
                Assert.That(value.GetCustomAttribute<InspectorNameAttribute>().displayName, Is.EqualTo(look.title));
            }
        }
    }
}
