using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEngine;

namespace Penumbra.Tests
{
    public sealed class ChainProgramsTests
    {
        private static readonly PenumbraShadowsVolume[] NoVolumes = new PenumbraShadowsVolume[0];
        private static readonly string[] Passes =
        {
            "PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve", "DenoiseHorizontal", "DenoiseVertical",
            "ConservativeMask", "QuarterDepthPlanes", "DepthPlanesMip", "ScreenTrace", "Accumulate",
            "CloudMap", "FarShadows",
        };

        private static ChainPrograms Of(QualityPreset preset, params PenumbraShadowsVolume[] volumes) =>
            ChainPrograms.Of(new[] { new PenumbraShadowsSettings { preset = preset } }, volumes);

        private static ChainPrograms Of(ShadowOptions custom, params PenumbraShadowsVolume[] volumes) =>
            ChainPrograms.Of(new[]
            {
                new PenumbraShadowsSettings
                {
                    preset = QualityPreset.Custom, custom = custom, contactShadowMetres = custom.contactShadowMetres,
                    farShadows = new FarShadowsSettings { mode = custom.farShadows, clouds = custom.clouds },
                    noise = custom.accumulates ? NoiseMode.Accumulated : NoiseMode.Static,
                },
            }, volumes);

        private static PenumbraShadowsVolume Volume(Action<PenumbraShadowsVolume> set)
        {
            var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
            set(volume);
            return volume;
        }

        // The passes of the frame itself, and those that make the maps of techniques.
        private static readonly (string asset, string pass)[] AllPasses =
            Passes.Select(pass => (Asset(pass), pass))
                .Union(TechniqueTable.Entries.SelectMany(entry => entry.formats.Select(format => format.graph)
                                                             .Append(entry.halfGraph)).Where(graph => graph != null)
                           .SelectMany(graph => graph.passes).Select(pass => (pass.asset, pass.program))).ToArray();

        // A program is for example "Resolve _PENUMBRA_PCSS": only the pass that filters, and the mask that foretells a
        // filter, declare keywords.
        private static IEnumerable<(string asset, string pass, string[] keywords)> EveryProgram()
        {
            foreach ((string asset, string pass) in AllPasses)
            {
                if (Declared(pass).Count == 0)
                {
                    yield return (asset, pass, new string[0]);
                    continue;
                }
                foreach (string technique in TechniqueTable.Entries.Select(entry => entry.keyword).Distinct()
                             .Where(name => name == null || Declared(pass).Contains(name)))
                    yield return (asset, pass, technique == null ? new string[0] : new[] { technique });
            }
        }

        private static string Asset(string program) =>
            ChainGraphs.All.SelectMany(graph => graph.passes).First(pass => pass.program == program).asset;

        // A kernel may have the name of a pass.
        private static string Text(string asset, string pass, IEnumerable<string> keywords) =>
            string.Join(" ", keywords.Prepend(asset.EndsWith(".compute") ? "kernel " + pass : pass));

        private static IReadOnlyCollection<string> Declared(string pass)
        {
            if (pass == "ConservativeMask") return new[] { "_PENUMBRA_PCSS" };
            return pass == "Resolve" ? ChainKeywords.OfTechniques.ToArray() : new string[0];
        }

        private static string[] Kept(ChainPrograms programs) =>
            EveryProgram().Where(program => programs.Has(program.asset, program.pass,
                                                         Declared(program.pass), program.keywords.Contains))
                .Select(program => Text(program.asset, program.pass, program.keywords)).ToArray();

        private static IEnumerable<string> Asked(in ShadowOptions options)
        {
            ShadowChain chain = ShadowChain.Of(options);
            IEnumerable<string> asked = chain.Steps.Select(
                step => Text(step.pass.asset, step.pass.program,
                             chain.Keywords.Where(Declared(step.pass.program).Contains)));
            // Some devices draw these instead, and scenes without ground draw without it.
            if (ChainSubstitute.TryGet(options, out ShadowOptions instead)) asked = asked.Union(Asked(instead));
            if (options.farShadows == FarShadowMode.Off) return asked;
            instead = options;
            instead.farShadows = FarShadowMode.Off;
            return asked.Union(Asked(instead));
        }

        // This program is drawn in the place of PCSS below shader target 4.5.
        private const string Tent = "Resolve _PENUMBRA_TENT_7X7";

        // The presets also keep the programs of what is drawn where the device cannot run their passes.
        private static readonly string[] Fallback = { Tent, "Resolve _PENUMBRA_PCSS_BOUNDED" };

        private static readonly string[] Kernels = { "Bounds", "DecideTiles", "FilterTiles", "SmoothNear" };
        private static readonly string[] LastKernels = { "SmoothFar" }, HalfKernels = { "SmoothFarNoisy", "Upsample" };

        private static IEnumerable<string> OfPreset(params string[] lastKernels) =>
            Fallback.Concat(Kernels.Concat(lastKernels).Select(kernel => "kernel " + kernel));

        [Test]
        public void APresetKeepsItsOwnPassesAndOneVariantOfEach()
        {
            foreach (QualityPreset preset in Enum.GetValues(typeof(QualityPreset)))
                Assert.That(Kept(Of(preset)),
                            Is.EqualTo(OfPreset(preset == QualityPreset.Low ? HalfKernels : LastKernels)), preset.ToString());
        }

        [Test]
        public void FeaturesOfAllRenderersCount()
        {
            var tent = new PenumbraShadowsSettings { preset = QualityPreset.Custom };
            tent.custom.technique = ShadowTechnique.Tent5x5;
            tent.custom.mask = false;
            var features = new[] { tent, new PenumbraShadowsSettings { preset = QualityPreset.Reference } };
            Assert.That(Kept(ChainPrograms.Of(features, NoVolumes)),
                        Is.EquivalentTo(OfPreset(LastKernels).Append("Resolve")));
        }

        [Test]
        public void WithoutAFeatureNothingIsKept() =>
            Assert.That(Kept(ChainPrograms.Of(new PenumbraShadowsSettings[0],
                                              new[] { Volume(volume => volume.mask.Set(true)) })), Is.Empty);

        [Test]
        public void APassThatNoChainHasIsNotKept() =>
            Assert.That(Of(QualityPreset.Ultra).Has(PenumbraShadows.ShaderFile, "Another", new string[0], name => false), Is.False);

        [Test]
        public void TwoTechniquesAtOnceAreNobodys() =>
            Assert.That(Of(QualityPreset.High).Has(PenumbraShadows.ShaderFile, "Resolve", ChainKeywords.All, name => true), Is.False);

        [Test]
        public void AStageThatDeclaresNoKeywordIsKeptOnceForAll() =>
            Assert.That(Of(QualityPreset.High).Has(PenumbraShadows.ShaderFile, "Resolve", new string[0], name => false));

        // The programs are for example "FarShadows _PENUMBRA_CLOUDS".
        private static string[] KeptOfFar(PenumbraShadowsSettings settings)
        {
            ChainPrograms programs = ChainPrograms.Of(new[] { settings }, NoVolumes);
            var declared = new[] { "_PENUMBRA_FAR_HORIZON", "_PENUMBRA_FAR_HEIGHTS", "_PENUMBRA_CLOUDS" };
            return (from ground in new[] { null, declared[0], declared[1] }
                    from clouds in new[] { null, declared[2] }
                    let enabled = new[] { ground, clouds }
                    where programs.Has("Shaders/PenumbraFar.shader", "FarShadows", declared, enabled.Contains)
                    select string.Join(" ", enabled.Where(name => name != null))).ToArray();
        }

        /// <summary>Programs are also kept for scenes without ground and for devices that cannot draw clouds.</summary>
        [Test]
        public void FarShadowsAreKeptAsTheFeatureHasThem()
        {
            var settings = new PenumbraShadowsSettings { preset = QualityPreset.High };
            Assert.That(KeptOfFar(settings), Is.Empty);
            settings.farShadows.mode = FarShadowMode.HeightMap;
            Assert.That(KeptOfFar(settings), Is.EqualTo(new[] { "_PENUMBRA_FAR_HEIGHTS" }));
            settings.farShadows.mode = FarShadowMode.HorizonAngles;
            Assert.That(KeptOfFar(settings), Is.EqualTo(new[] { "_PENUMBRA_FAR_HORIZON" }));
            settings.farShadows.clouds = true;
            Assert.That(KeptOfFar(settings), Is.EquivalentTo(new[]
            {
                "_PENUMBRA_FAR_HORIZON _PENUMBRA_CLOUDS", "_PENUMBRA_FAR_HORIZON", "_PENUMBRA_CLOUDS",
            }));
            settings.farShadows.mode = FarShadowMode.Off;
            Assert.That(KeptOfFar(settings), Is.EqualTo(new[] { "_PENUMBRA_CLOUDS" }));
            Assert.That(ChainPrograms.Of(new[] { settings }, NoVolumes)
                            .Has("Shaders/PenumbraFar.shader", "FarShadowsAlone", new string[0], name => false), Is.False);
        }

        // Options that VolumeOverrides leaves out must not choose programs.
        [Test]
        public void EveryOptionThatChangesAChainIsMinded()
        {
            foreach (QualityPreset preset in Enum.GetValues(typeof(QualityPreset)))
                foreach (System.Reflection.FieldInfo field in typeof(ShadowOptions).GetFields())
                    foreach (object value in Values(field.FieldType))
                    {
                        object options = ShadowPresets.Options(preset);
                        field.SetValue(options, value);
                        Assert.That(Kept(Of((ShadowOptions)options)),
                                    Is.EquivalentTo(Asked(((ShadowOptions)options).Clamped()).Distinct()),
                                    preset + ", " + field.Name + " " + value);
                    }
        }

        private static IEnumerable<object> Values(Type type)
        {
            if (type.IsEnum) return Enum.GetValues(type).Cast<object>();
            if (type == typeof(bool)) return new object[] { false, true };
            if (type == typeof(int)) return new object[] { 1, 64 };
            Assert.That(type, Is.EqualTo(typeof(float)), "an option of a new type");
            return new object[] { 0.0f, 1e-3f, 8.0f };
        }

        // The programs cover everything that a few Volumes come to in any order and however far each has faded in, as
        // Unity blends them.
        [Test]
        public void VolumesThatMeetAskForAllThatIsKeptAndNoMore()
        {
            var random = new System.Random(7);
            for (int round = 0; round < 60; ++round)
            {
                PenumbraShadowsVolume[] volumes = Enumerable.Range(0, random.Next(4))
                    .Select(_ => Volume(one => RandomOverrides(one, random))).ToArray();
                var settings = new PenumbraShadowsSettings
                {
                    preset = Random<QualityPreset>(random), angularDiameterDegrees = random.Next(4) * 0.5f,
                };
                var asked = new HashSet<string>(Asked(settings.Options()));
                foreach (PenumbraShadowsVolume[] meeting in Orders(volumes))
                    for (int faded = 0; faded < 1 << meeting.Length; ++faded)
                        asked.UnionWith(Asked(Blended(meeting, faded).Over(settings.Options())));
                Assert.That(Kept(ChainPrograms.Of(new[] { settings }, volumes)), Is.EquivalentTo(asked),
                            "round " + round);
            }
        }

        private static T Random<T>(System.Random random) where T : Enum
        {
            Array values = Enum.GetValues(typeof(T));
            return (T)values.GetValue(random.Next(values.Length));
        }

        private static void RandomOverrides(PenumbraShadowsVolume volume, System.Random random)
        {
            if (random.Next(3) == 0) volume.preset.Set(Random<QualityPreset>(random));
            if (random.Next(3) == 0) volume.technique.Set(Random<ShadowTechnique>(random));
            if (random.Next(3) == 0) volume.angularDiameterDegrees.Set(random.Next(2) * 0.5f);
            if (random.Next(3) == 0) volume.mask.Set(random.Next(2) == 0);
            if (random.Next(3) == 0) volume.conservativeMask.Set(random.Next(2) == 0);
            if (random.Next(3) == 0) volume.halfResolution.Set(random.Next(2) == 0);
            if (random.Next(3) == 0) volume.denoise.Set(random.Next(2) == 0);
            if (random.Next(3) == 0) volume.contactShadowMetres.Set(random.Next(2) * 0.5f);
            if (random.Next(3) == 0) volume.filterSamples.Set(random.Next(1, 65));
        }

        // The orders of every subset.
        private static IEnumerable<PenumbraShadowsVolume[]> Orders(PenumbraShadowsVolume[] volumes)
        {
            yield return new PenumbraShadowsVolume[0];
            foreach (PenumbraShadowsVolume first in volumes)
                foreach (PenumbraShadowsVolume[] rest in Orders(volumes.Where(other => other != first).ToArray()))
                    yield return rest.Prepend(first).ToArray();
        }

        // The stack after all of `meeting`, those in the bits of `faded` at half their weight.
        private static PenumbraShadowsVolume Blended(PenumbraShadowsVolume[] meeting, int faded)
        {
            PenumbraShadowsVolume stack = Volume(_ => { });
            for (int i = 0; i < meeting.Length; ++i)
            {
                float weight = (faded >> i & 1) != 0 ? 0.5f : 1.0f;
                Take(stack.preset, meeting[i].preset);
                Take(stack.technique, meeting[i].technique);
                Take(stack.mask, meeting[i].mask);
                Take(stack.conservativeMask, meeting[i].conservativeMask);
                Take(stack.halfResolution, meeting[i].halfResolution);
                Take(stack.denoise, meeting[i].denoise);
                Blend(stack.angularDiameterDegrees, meeting[i].angularDiameterDegrees, weight);
                Blend(stack.contactShadowMetres, meeting[i].contactShadowMetres, weight);
            }
            return stack;
        }

        private static void Blend(UnityEngine.Rendering.VolumeParameter<float> stack,
                                  UnityEngine.Rendering.VolumeParameter<float> volume, float weight)
        {
            if (volume.overrideState) stack.Set(stack.value + (volume.value - stack.value) * weight);
        }

        private static void Take<T>(UnityEngine.Rendering.VolumeParameter<T> stack,
                                    UnityEngine.Rendering.VolumeParameter<T> volume)
        {
            if (volume.overrideState) stack.Set(volume.value);
        }

        [TestCase(true, false, false)]
        [TestCase(true, true, true)]
        [TestCase(false, false, true)]
        public void OpaqueReceiversOfTheScreenTextureStay(bool screen, bool transparent, bool canRemove) =>
            Assert.That(ScreenShadowStripper.CanRemove(screen, transparent, isDrawnByNobody: false),
                        Is.EqualTo(canRemove));

        [TestCase("Universal Render Pipeline/Lit", "GBuffer", true)]
        [TestCase("Universal Render Pipeline/Lit", "ForwardLit", false)]
        [TestCase("Hidden/Universal Render Pipeline/StencilDeferred", "Deferred Directional Light (Lit)", true)]
        [TestCase("Hidden/Universal Render Pipeline/ClusterDeferred", "Deferred Clustered Lights (Lit)", true)]
        public void WithoutADeferredRendererItsPassesGo(string shader, string pass, bool ofDeferred)
        {
            Assert.That(ScreenShadowStripper.IsOfDeferred(shader, pass), Is.EqualTo(ofDeferred));
            Assert.That(ScreenShadowStripper.CanRemove(true, false, isDrawnByNobody: ofDeferred), Is.EqualTo(ofDeferred));
        }
    }
}
