using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace Penumbra.Tests
{
    public sealed class ShadowChainTests
    {
        private static ShadowOptions Options(bool mask, bool half, bool denoise,
                                             ShadowTechnique technique = ShadowTechnique.Pcss)
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.Custom);
            options.technique = technique;
            options.mask = mask;
            options.halfResolution = half;
            options.denoise = denoise;
            return options;
        }

        private static ShadowChain Chain(ShadowOptions options) => ShadowChain.Of(options, ShadowPassList.All);

        private static string[] Names(ShadowOptions options) =>
            Chain(options).Steps.Select(step => step.shaderPass).ToArray();

        private static IEnumerable<ShadowOptions> EveryChain()
        {
            foreach (ShadowTechnique technique in System.Enum.GetValues(typeof(ShadowTechnique)))
                for (int bits = 0; bits < 8; ++bits)
                    yield return Options((bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, technique);
        }

        [Test]
        public void DrawsOnlyWhatTheOptionsNeed()
        {
            Assert.That(Names(Options(false, false, false)), Is.EqualTo(new[] { "Resolve" }));
            Assert.That(Names(Options(true, false, false)),
                        Is.EqualTo(new[] { "PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve" }));
            Assert.That(Names(Options(false, true, false)), Is.EqualTo(new[] { "Resolve", "Upsample" }));
            Assert.That(Names(Options(false, false, true)),
                        Is.EqualTo(new[] { "Resolve", "DenoiseHorizontal", "DenoiseVertical" }));
            Assert.That(Names(Options(true, true, true)),
                        Is.EqualTo(new[] { "PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve",
                                           "Upsample", "DenoiseHorizontal", "DenoiseVertical" }));
        }

        [Test]
        public void TentsHaveNeitherMaskNorNoise() =>
            Assert.That(Names(Options(true, false, true, ShadowTechnique.Tent5x5)), Is.EqualTo(new[] { "Resolve" }));

        [Test]
        public void APointLightHasNoPenumbra()
        {
            ShadowOptions options = Options(true, false, true);
            options.angularDiameterDegrees = 0.0f;
            Assert.That(Names(options), Is.EqualTo(new[] { "Resolve" }));
        }

        [TestCaseSource(nameof(EveryChain))]
        public void EveryChainEndsInTheTextureThatReceiversRead(ShadowOptions options)
        {
            ShadowChain chain = Chain(options);
            Assert.That(chain.Visibility, Is.EqualTo(ShadowChain.Output));
            Assert.That(chain.Steps[chain.Steps.Count - 1].target, Is.EqualTo(ShadowChain.Output));
            Assert.That(chain.Slots[ShadowChain.Output].divisor, Is.EqualTo(1));
        }

        [TestCaseSource(nameof(EveryChain))]
        public void WhatADrawReadsIsThereAndNotItsOwnTarget(ShadowOptions options)
        {
            var holds = new Dictionary<int, string>();
            foreach (ChainStep step in Chain(options).Steps)
            {
                Assert.That(step.source, Is.Not.EqualTo(step.target));
                Assert.That(step.mask == ShadowChain.None || step.mask != step.target);
                if (step.source != ShadowChain.None) Assert.That(holds.Keys, Has.Member(step.source));
                if (step.mask != ShadowChain.None)
                    Assert.That(holds[step.mask], Is.EqualTo("MaskBlurVertical"), "the mask was overwritten");
                if (step.shaderPass == "Resolve")
                    Assert.That(step.mask == ShadowChain.None, Is.EqualTo(!options.mask || !options.technique.TakesSamples()));
                holds[step.target] = step.shaderPass;
            }
        }

        [Test]
        public void TexturesThatAreNotAliveTogetherShareASlot()
        {
            // Of seven textures: the upsampled lies where the result will, the mask where its first version was.
            ShadowChain chain = Chain(Options(true, true, true));
            Assert.That(chain.Slots.Select(slot => slot.divisor), Is.EqualTo(new[] { 1, 4, 4, 2, 1 }));
        }

        private sealed class TwoQuarterPasses : ShadowPass
        {
            internal override int Order => 350;
            internal override bool IsNeeded(in ShadowOptions options) => true;
            internal override void AddSteps(ShadowChain chain, in ShadowOptions options) =>
                chain.Draw("Second", MaskPass.Divisor, chain.Draw("First", MaskPass.Divisor));
        }

        /// <summary>A debug view shows it after the chain.</summary>
        [Test]
        public void TheMaskIsNotWrittenOver()
        {
            ShadowPass[] passes =
                ShadowPassList.All.Append(new TwoQuarterPasses()).OrderBy(pass => pass.Order).ToArray();
            ShadowChain chain = ShadowChain.Of(Options(true, false, true), passes);
            ChainStep[] later = chain.Steps.SkipWhile(step => step.shaderPass != "Resolve").ToArray();
            Assert.That(later.Length, Is.EqualTo(5));
            Assert.That(later.Select(step => step.target), Has.None.EqualTo(chain.Mask));
        }

        [TestCase(1, 1920, 1920)]
        [TestCase(2, 1921, 961)]
        [TestCase(4, 1921, 481)]
        [TestCase(4, 2, 1)]
        public void SlotsRoundUp(int divisor, int screen, int size) =>
            Assert.That(new ChainSlot(divisor).Size(screen), Is.EqualTo(size));

        [Test]
        public void PassesAreFoundInTheirOrder()
        {
            Assert.That(ShadowPassList.All.Select(pass => pass.Order), Is.Ordered.And.Unique);
            Assert.That(ShadowPassList.All.Select(pass => pass.GetType()),
                        Is.EqualTo(new[] { typeof(MaskPass), typeof(ResolvePass), typeof(UpsamplePass),
                                           typeof(DenoisePass) }));
        }

        private sealed class WithoutVisibility : ShadowPass
        {
            internal override int Order => 1;
            internal override bool IsNeeded(in ShadowOptions options) => true;
            internal override void AddSteps(ShadowChain chain, in ShadowOptions options) => chain.Draw("Mine", 1);
        }

        [Test]
        public void AChainWithoutAResultIsRefused() =>
            Assert.That(() => ShadowChain.Of(default, new ShadowPass[] { new WithoutVisibility() }),
                        Throws.InvalidOperationException.With.Message.Contains("visibility"));
    }
}
