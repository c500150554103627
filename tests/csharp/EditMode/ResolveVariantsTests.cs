using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEngine;

namespace Penumbra.Tests
{
    public sealed class ResolveVariantsTests
    {
        private static readonly PenumbraShadowsVolume[] NoVolumes = new PenumbraShadowsVolume[0];

        private static ResolveVariants Of(QualityPreset preset, params PenumbraShadowsVolume[] volumes) =>
            ResolveVariants.Of(new[] { new PenumbraShadowsSettings { preset = preset } }, volumes);

        private static IEnumerable<string[]> EverySet()
        {
            var sets = new List<string[]> { new string[0] };
            foreach (string name in TechniqueKeywords.Names.Where(name => name != null)) sets.Add(new[] { name });
            return sets.Concat(sets.Select(set => set.Append(TechniqueKeywords.Mask).ToArray()).ToList());
        }

        private static string[] Used(ResolveVariants variants) =>
            EverySet().Where(set => variants.Uses(set.Contains)).Select(set => string.Join(" ", set)).ToArray();

        [Test]
        public void APresetUsesOneVariant()
        {
            Assert.That(Used(Of(QualityPreset.Low)), Is.EqualTo(new[] { "" }));
            Assert.That(Used(Of(QualityPreset.High)), Is.EqualTo(new[] { "_PENUMBRA_PCSS _PENUMBRA_MASK" }));
            Assert.That(Used(Of(QualityPreset.Reference)), Is.EqualTo(new[] { "_PENUMBRA_PCSS" }));
        }

        [Test]
        public void WhatAFrameAsksForIsAlwaysThere()
        {
            foreach (QualityPreset preset in Enum.GetValues(typeof(QualityPreset)))
            {
                ShadowOptions options = ShadowPresets.Options(preset);
                ShadowChain chain = ShadowChain.Of(options, ShadowPassList.All);
                var asked = new List<string>();
                string technique = TechniqueKeywords.Names[(int)options.technique];
                if (technique != null) asked.Add(technique);
                if (chain.Mask != ShadowChain.None) asked.Add(TechniqueKeywords.Mask);
                Assert.That(Of(preset).Uses(asked.Contains), preset.ToString());
            }
        }

        [Test]
        public void VolumesAreCombined()
        {
            var technique = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
            technique.technique.overrideState = true;
            technique.technique.value = ShadowTechnique.PcssHdrp;
            var mask = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
            mask.mask.overrideState = true;
            mask.mask.value = true;
            Assert.That(Used(Of(QualityPreset.Reference, technique, mask)),
                        Is.EquivalentTo(new[] { "_PENUMBRA_PCSS", "_PENUMBRA_PCSS_HDRP", "_PENUMBRA_PCSS _PENUMBRA_MASK",
                                                "_PENUMBRA_PCSS_HDRP _PENUMBRA_MASK" }));
        }

        [Test]
        public void TwoTechniquesAtOnceAreNobodys() =>
            Assert.That(Of(QualityPreset.High).Uses(name => name != TechniqueKeywords.Names[0]), Is.False);

        [Test]
        public void WithoutAFeatureNothingIsUsed() =>
            Assert.That(Used(ResolveVariants.Of(new PenumbraShadowsSettings[0], NoVolumes)), Is.Empty);

        [TestCase(true, false, false)]
        [TestCase(true, true, true)]
        [TestCase(false, false, true)]
        public void OpaqueReceiversOfTheScreenTextureStay(bool screen, bool transparent, bool canRemove) =>
            Assert.That(ScreenShadowStripper.CanRemove(screen, transparent), Is.EqualTo(canRemove));
    }
}
