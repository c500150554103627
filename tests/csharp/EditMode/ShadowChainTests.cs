using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine.Experimental.Rendering;

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
                if (step.source != ShadowChain.None) Assert.That(holds.Keys, Has.Member(step.source));
                if (step.shaderPass != "Resolve") { holds[step.target] = step.shaderPass; continue; }
                int mask = Chain(options).Published(MaskPass.Texture);
                Assert.That(mask == ShadowChain.None, Is.EqualTo(!options.mask || !options.technique.TakesSamples()));
                if (mask != ShadowChain.None)
                    Assert.That(holds[mask], Is.EqualTo("MaskBlurVertical"), "the mask was overwritten");
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
            Assert.That(later.Select(step => step.target), Has.None.EqualTo(chain.Published(MaskPass.Texture)));
        }

        [TestCase(1, 1920, 1920)]
        [TestCase(2, 1921, 961)]
        [TestCase(4, 1921, 481)]
        [TestCase(4, 2, 1)]
        public void SlotsRoundUp(int divisor, int screen, int size) =>
            Assert.That(ChainTexture.OfScreen(divisor).Size(screen), Is.EqualTo(size));

        [Test]
        public void PassesAreFoundInTheirOrder()
        {
            Assert.That(ShadowPassList.All.Select(pass => pass.Order), Is.Ordered.And.Unique);
            Assert.That(ShadowPassList.All.Select(pass => pass.GetType()),
                        Is.EqualTo(new[] { typeof(MaskPass), typeof(ResolvePass), typeof(UpsamplePass),
                                           typeof(DenoisePass) }));
        }

        /// <summary>What a later one could be: a reduction of the shadow map by a compute shader, read by name.</summary>
        private sealed class MapReduction : ShadowPass
        {
            internal static readonly ChainTexture Half =
                new ChainTexture(ChainExtent.ShadowMap, 2, GraphicsFormat.B8G8R8A8_UNorm, randomWrite: true);

            internal override int Order => 50;
            internal override string Keyword => "_MAP_REDUCTION";
            internal override bool IsNeeded(in ShadowOptions options) => options.mask;

            internal override void AddSteps(ShadowChain chain, in ShadowOptions options)
            {
                int half = chain.Run(this, 0, Half);
                var quarter = new ChainTexture(ChainExtent.ShadowMap, 4, Half.format, randomWrite: true);
                chain.Publish(chain.Run(this, 1, quarter, half), 7);
            }
        }

        [Test]
        public void APassMayRecordStepsOfItsOwnIntoTexturesOfItsOwn()
        {
            var reduction = new MapReduction();
            ShadowPass[] passes = ShadowPassList.All.Append(reduction).OrderBy(pass => pass.Order).ToArray();
            ShadowChain chain = ShadowChain.Of(Options(true, true, true), passes);
            Assert.That(chain.Steps.Take(2).Select(step => step.recorder), Is.All.SameAs(reduction));
            Assert.That(chain.Steps.Take(2).Select(step => step.run), Is.EqualTo(new[] { 0, 1 }));
            Assert.That(chain.Steps[1].source, Is.EqualTo(chain.Steps[0].target));
            Assert.That(chain.Slots[chain.Steps[0].target], Is.EqualTo(MapReduction.Half));
            Assert.That(chain.Published(7), Is.EqualTo(chain.Steps[1].target));
            Assert.That(chain.Steps.Skip(2).Select(step => step.target), Has.None.EqualTo(chain.Published(7)));
            Assert.That(chain.Keywords, Has.Member("_MAP_REDUCTION"));
            Assert.That(ShadowChain.Of(Options(false, true, true), passes).Keywords, Has.None.EqualTo("_MAP_REDUCTION"));
        }

        [Test]
        public void AStepThatNobodyRecordsIsRefused() =>
            Assert.That(() => new MapReduction().Record(null, default, null, 0),
                        Throws.TypeOf<System.NotSupportedException>().With.Message.Contains("MapReduction"));

        [Test]
        public void TheKeywordsAreTheTechniquesAndThePasses() =>
            Assert.That(ChainKeywords.All, Is.EquivalentTo(TechniqueTable.Keywords.Where(name => name != null)
                                                               .Append("_PENUMBRA_MASK")));

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
