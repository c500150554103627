using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra.Tests
{
    public sealed class ShadowChainTests
    {
        private static ShadowOptions Options(bool mask, bool half, bool denoise,
                                             ShadowTechnique technique = ShadowTechnique.Pcss,
                                             bool conservative = false)
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.Custom);
            options.technique = technique;
            options.mask = mask;
            options.conservativeMask = conservative;
            options.halfResolution = half;
            options.denoise = denoise;
            return options;
        }

        private static string[] Names(ShadowOptions options) =>
            ShadowChain.Of(options).Steps.Select(step => step.pass.program).ToArray();

        private static IEnumerable<ShadowOptions> EveryChain()
        {
            foreach (ShadowTechnique technique in System.Enum.GetValues(typeof(ShadowTechnique)))
                for (int bits = 0; bits < 192; ++bits)
                {
                    ShadowOptions options = Options((bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, technique,
                                                    (bits & 8) != 0);
                    options.contactShadowMetres = (bits & 16) != 0 ? 0.5f : 0.0f;
                    options.clouds = (bits & 32) != 0;
                    options.farShadows = (FarShadowMode)(bits / 64);
                    yield return options;
                }
        }

        private static readonly string[] Mask = { "PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical" };
        private static readonly string[] ConservativeMask = { "QuarterDepthPlanes", "DepthPlanesMip", "ConservativeMask" };
        private static readonly string[] Denoise = { "DenoiseHorizontal", "DenoiseVertical" };

        [Test]
        public void DrawsOnlyWhatTheOptionsNeed()
        {
            for (int bits = 0; bits < 16; ++bits)
            {
                bool mask = (bits & 1) != 0, half = (bits & 2) != 0, denoise = (bits & 4) != 0;
                bool conservative = (bits & 8) != 0;
                IEnumerable<string> expected = !mask ? new string[0] : conservative ? ConservativeMask : Mask;
                expected = expected.Append("Resolve");
                if (half) expected = expected.Append("Resolve");
                if (denoise) expected = expected.Concat(Denoise);
                Assert.That(Names(Options(mask, half, denoise, ShadowTechnique.Pcss, conservative)), Is.EqualTo(expected));
            }
        }

        [TestCaseSource(nameof(EveryChain))]
        public void ContactShadowsComeAfterTheFilterAndReadTheVisibilityBefore(ShadowOptions options)
        {
            options.farShadows = FarShadowMode.Off;
            options.clouds = false;
            options.contactShadowMetres = 0.0f;
            string[] without = Names(options);
            int before = ShadowChain.Of(options).Slots[ShadowChain.Output].divisor;
            options.contactShadowMetres = 1e-3f;
            ShadowChain chain = ShadowChain.Of(options);
            Assert.That(Names(options), Is.EqualTo(without.Append("ScreenTrace")));
            ChainStep trace = chain.Steps.Last();
            ChainStep filtered = chain.Steps[chain.Steps.Count - 2];
            Assert.That(trace.reads.Single().property, Is.EqualTo(Shader.PropertyToID("_PenumbraSourceTexture")));
            Assert.That(trace.reads.Single().index, Is.EqualTo(filtered.Target));
            Assert.That(trace.Target, Is.EqualTo(ShadowChain.Output));
            Assert.That(chain.Slots[filtered.Target].divisor, Is.EqualTo(before));
        }

        private static string[] Beyond(bool clouds) => clouds ? new[] { "CloudMap", "FarShadows" } : new[] { "FarShadows" };

        [TestCaseSource(nameof(EveryChain))]
        public void WhatIsBeyondTheCascadesComesLastAndReadsTheVisibilityBefore(ShadowOptions options)
        {
            if (!options.DrawsBeyondCascades) return;
            ShadowOptions near = options;
            near.farShadows = FarShadowMode.Off;
            near.clouds = false;
            ShadowChain chain = ShadowChain.Of(options);
            string[] without = Names(near);
            Assert.That(Names(options), Is.EqualTo(without.Concat(Beyond(options.clouds))));
            ChainStep far = chain.Steps.Last();
            int Read(string name) => far.reads.Single(read => read.property == Shader.PropertyToID(name)).index;
            Assert.That(far.Target, Is.EqualTo(ShadowChain.Output));
            Assert.That(Read("_PenumbraSourceTexture"), Is.EqualTo(chain.Steps[without.Length - 1].Target));
            if (options.clouds) Assert.That(Read("_PenumbraCloudTexture"), Is.EqualTo(chain.Steps[without.Length].Target));
            var keywords = new[] { "_PENUMBRA_FAR_HEIGHTS", "_PENUMBRA_FAR_HORIZON", "_PENUMBRA_CLOUDS" };
            Assert.That(chain.Keywords.Intersect(keywords), Is.EquivalentTo(keywords.Where(
                (keyword, i) => i == 2 ? options.clouds : (int)options.farShadows == i + 1)));
        }

        /// <summary>A pass that darkens the visibility further would be written like this one.</summary>
        [Test]
        public void GraphsThatReadTheVisibilityFollowOneAnother()
        {
            TechniqueGraph Darker(string name) => new TechniqueGraph
            {
                name = name,
                textures = new[] { Texture("own"), Texture("before"), Texture("after") },
                source = 1,
                passes = new[]
                {
                    Pass(name + "Own", PassFrequency.Frame, 0),
                    Pass(name, PassFrequency.Frame, 2, GraphBinding.Texture("_A", 0), GraphBinding.Texture("_B", 1)),
                },
                visibility = 2,
            };
            var chain = new ShadowChain(new[] { TechniqueTable.Graph("pcss"), Darker("First"), Darker("Second") }, null);
            Assert.That(chain.Steps.Select(step => step.pass.program),
                        Is.EqualTo(new[] { "Resolve", "FirstOwn", "First", "SecondOwn", "Second" }));
            Assert.That(chain.Steps[2].reads.Select(read => read.index),
                        Is.EqualTo(new[] { chain.Steps[1].Target, chain.Steps[0].Target }));
            Assert.That(chain.Steps[4].reads.Select(read => read.index),
                        Is.EqualTo(new[] { chain.Steps[3].Target, chain.Steps[2].Target }));
            Assert.That(chain.Steps[4].Target, Is.EqualTo(ShadowChain.Output));
            Assert.That(chain.Steps[1].Target, Is.Not.EqualTo(chain.Steps[0].Target), "it is read later");
            Assert.That(() => new ShadowChain(new[] { Darker("Alone") }, null),
                        Throws.InvalidOperationException.With.Message.Contains("Alone"));
        }

        [Test]
        public void TentsHaveNeitherMaskNorNoise() =>
            Assert.That(Names(Options(true, false, true, ShadowTechnique.Tent5x5)), Is.EqualTo(new[] { "Resolve" }));

        [Test]
        public void AConservativeMaskIsForPcssAlone()
        {
            foreach (ShadowTechnique other in new[] { ShadowTechnique.PcssPoisson, ShadowTechnique.PcssHdrp })
                Assert.That(Names(Options(true, false, false, other, conservative: true)),
                            Is.EqualTo(Mask.Append("Resolve")), other.ToString());
        }

        [Test]
        public void APointLightHasNoPenumbra()
        {
            ShadowOptions options = Options(true, false, true);
            options.angularDiameterDegrees = 0.0f;
            Assert.That(Names(options), Is.EqualTo(new[] { "Resolve" }));
        }

        [TestCaseSource(nameof(EveryChain))]
        public void OptionsOfOneKeyNeedOneChain(ShadowOptions options)
        {
            foreach (ShadowOptions other in EveryChain())
                if (ChainGraphs.Key(options) == ChainGraphs.Key(other))
                {
                    Assert.That(Names(other), Is.EqualTo(Names(options)));
                    Assert.That(ShadowChain.Of(other).Keywords, Is.EqualTo(ShadowChain.Of(options).Keywords));
                }
        }

        [TestCaseSource(nameof(EveryChain))]
        public void EveryChainEndsInTheTextureThatReceiversRead(ShadowOptions options)
        {
            ShadowChain chain = ShadowChain.Of(options);
            Assert.That(chain.Steps.Last().Target, Is.EqualTo(ShadowChain.Output));
            Assert.That(chain.Slots[ShadowChain.Output].divisor, Is.EqualTo(1));
            Assert.That(chain.SlotNames, Is.Unique);
            Assert.That(chain.SlotNames[ShadowChain.Output], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
        }

        private static string MaskOf(in ShadowOptions options) =>
            options.MasksConservatively ? "ConservativeMask" : "MaskBlurVertical";

        [TestCaseSource(nameof(EveryChain))]
        public void WhatADrawReadsIsThereAndNotItsOwnTarget(ShadowOptions options)
        {
            ShadowChain chain = ShadowChain.Of(options);
            var holds = new Dictionary<int, string>();
            foreach (ChainStep step in chain.Steps)
            {
                foreach (ChainBinding read in step.reads)
                {
                    if (!step.pass.eachMip)
                        Assert.That(step.writes.Any(write => write.index == read.index), Is.False, step.pass.program);
                    Assert.That(holds.Keys, Has.Member(read.index));
                    if (read.property == Shader.PropertyToID("_PenumbraMaskTexture"))
                        Assert.That(holds[read.index], Is.EqualTo(MaskOf(options)), "the mask was overwritten");
                }
                for (int i = step.pass.writes.Length; i < step.writes.Length; ++i)
                    Assert.That(holds.Keys, Has.Member(step.writes[i].index), "it changes what is there");
                foreach (ChainBinding write in step.writes) holds[write.index] = step.pass.program;
            }
            bool masked = options.mask && options.technique.Entry().takesSamples;
            Assert.That(chain.Mask != ShadowChain.None, Is.EqualTo(masked));
            if (masked) Assert.That(holds[chain.Mask], Is.EqualTo(MaskOf(options)), "a debug view shows it");
        }

        private const string MaskTexture = "_PenumbraMaskTexture", SourceTexture = "_PenumbraSourceTexture";

        /// <summary>
        /// One program filters, with and without a mask, and upsamples: it learns from sizes what it has.
        /// </summary>
        [TestCaseSource(nameof(EveryChain))]
        public void WhatAResolveDoesNotReadIsAbsent(ShadowOptions options)
        {
            ShadowChain chain = ShadowChain.Of(options);
            ChainStep[] resolves = chain.Steps.Where(step => step.pass.program == "Resolve").ToArray();
            var reads = new List<string>();
            if (!options.DrawsVisibility) reads.Add(chain.Mask == ShadowChain.None ? null : MaskTexture);
            if (!options.DrawsVisibility && options.HalvesResolution) reads.Add(SourceTexture);
            Assert.That(resolves.Select(step => step.pass.reads.SingleOrDefault().property), Is.EqualTo(reads));
            foreach (ChainStep step in resolves)
            {
                string[] all = step.pass.reads.Select(read => read.property).Concat(step.pass.absent).ToArray();
                Assert.That(all, Is.EquivalentTo(new[] { MaskTexture, SourceTexture }));
                Assert.That(step.absentSizes, Is.EqualTo(step.pass.absent.Select(
                    texture => Shader.PropertyToID(texture.Replace("Texture", "Size")))));
            }
            IEnumerable<ChainStep> others = chain.Steps.Where(step => step.pass.asset != PenumbraShadows.ShaderFile);
            Assert.That(others.SelectMany(step => step.absentSizes), Is.Empty);
        }

        [Test]
        public void TexturesThatAreNotAliveTogetherShareASlot()
        {
            // The chain needs seven textures: the upsampled lies where the result will, the mask where its first
            // version was.
            ShadowChain chain = ShadowChain.Of(Options(true, true, true));
            Assert.That(chain.Slots.Select(slot => slot.divisor), Is.EqualTo(new[] { 1, 4, 4, 2, 1 }));
        }

        private static GraphPass Pass(string program, PassFrequency runs, int target, params GraphBinding[] reads) =>
            new GraphPass
            {
                asset = PenumbraShadows.ShaderFile, program = program, runs = runs, reads = reads,
                writes = new[] { GraphBinding.Texture(target) },
            };

        private static GraphTexture Texture(string name, GraphExtent extent = GraphExtent.Screen, int divisor = 1) =>
            new GraphTexture(name, extent, GraphicsFormat.R8_UNorm, divisor);

        // The graph makes the map's halves, once for each cascade that is new, and has a filter that reads them.
        private static TechniqueGraph MapGraph() => new TechniqueGraph
        {
            name = "map",
            textures = new[]
            {
                Texture("whole", GraphExtent.Map), Texture("half", GraphExtent.Map, 2),
                Texture("noise", GraphExtent.Map), Texture("table", GraphExtent.Map, 2),
            },
            passes = new[]
            {
                Pass("Noise", PassFrequency.Bake, 2), Pass("Table", PassFrequency.Bake, 3, GraphBinding.Texture("_A", 2)),
                Pass("Whole", PassFrequency.Cascade, 0), Pass("Half", PassFrequency.Cascade, 1,
                                                              GraphBinding.Texture("_A", 0), GraphBinding.Texture("_B", 3)),
            },
            keywords = new[] { "_HALVES" },
            filterTextures = new[] { GraphBinding.Texture("_PenumbraHalfTexture", 1) },
        };

        private static ShadowChain WithMapGraph() =>
            new ShadowChain(new[] { MapGraph(), TechniqueTable.Graph("pcss-masked") }, "_TECHNIQUE");

        [Test]
        public void AFiltersGraphRunsBeforeTheScreens()
        {
            ShadowChain chain = WithMapGraph();
            Assert.That(chain.Steps.Select(step => step.pass.program),
                        Is.EqualTo(new[] { "Noise", "Table", "Whole", "Half" }.Concat(Mask).Append("Resolve")));
            Assert.That(chain.Keywords, Is.EqualTo(new[] { "_TECHNIQUE", "_HALVES" }));
            ChainGlobal half = chain.Globals.Single();
            Assert.That(half.afterStep, Is.EqualTo(3));
            Assert.That(half.texture.property, Is.EqualTo(Shader.PropertyToID("_PenumbraHalfTexture")));
            Assert.That(half.texture.sizeProperty, Is.EqualTo(Shader.PropertyToID("_PenumbraHalfSize")));
            Assert.That(half.texture.index, Is.EqualTo(chain.Steps[3].Target));
        }

        /// <summary>A texture that is only read in frames in which it is written need not be kept.</summary>
        [Test]
        public void WhatIsReadMoreOftenThanWrittenIsKeptAndNobodyElses()
        {
            ShadowChain chain = WithMapGraph();
            string[] kept = chain.Steps.Where(step => chain.Slots[step.Target].kept)
                .Select(step => step.pass.program).ToArray();
            Assert.That(kept, Is.EqualTo(new[] { "Table", "Half" }));
            foreach (string program in kept)
            {
                int slot = chain.Steps.Single(step => step.pass.program == program).Target;
                Assert.That(chain.Steps.Count(step => step.Target == slot), Is.EqualTo(1), program);
            }
            int[] whole = new[] { 0, 2 }.Select(at => chain.Steps[at].Target).ToArray();
            Assert.That(whole[0], Is.EqualTo(whole[1]), "the noise is read no more when the first cascade is drawn");
        }

        /// <summary>A debug view shows the mask, so no pass may write over it.</summary>
        [Test]
        public void TheMaskIsNotWrittenOver()
        {
            var later = new TechniqueGraph
            {
                textures = new[] { Texture("a", divisor: 4), Texture("b", divisor: 4), Texture("visibility") },
                passes = new[]
                {
                    Pass("A", PassFrequency.Frame, 0), Pass("B", PassFrequency.Frame, 1, GraphBinding.Texture("_A", 0)),
                    Pass("C", PassFrequency.Frame, 2, GraphBinding.Texture("_B", 1)),
                },
                visibility = 2,
            };
            var chain = new ShadowChain(new[] { TechniqueTable.Graph("pcss-masked"), later }, null);
            ChainStep[] behind = chain.Steps.SkipWhile(step => step.pass.program != "Resolve").ToArray();
            Assert.That(behind.Length, Is.EqualTo(4));
            Assert.That(behind.Select(step => step.Target), Has.None.EqualTo(chain.Mask));
        }

        [Test]
        public void TheKeywordsAreTheTechniquesAndTheGraphs() =>
            Assert.That(ChainKeywords.All, Is.EquivalentTo(ChainKeywords.OfTechniques
                                                               .Append("_PENUMBRA_CLOUDS")
                                                               .Append("_PENUMBRA_BOTH_EYES")
                                                               .Append("_PENUMBRA_FAR_HEIGHTS")
                                                               .Append("_PENUMBRA_FAR_HORIZON")));

        [Test]
        public void AChainWithoutAResultIsRefused() =>
            Assert.That(() => new ShadowChain(new[] { MapGraph() }, null),
                        Throws.InvalidOperationException.With.Message.Contains("visibility"));
    }
}
