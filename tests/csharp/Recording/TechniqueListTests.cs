using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEngine.Experimental.Rendering;

namespace Penumbra.Tests
{
    /// <summary>What the passes are told is what the study measures them with.</summary>
    public sealed class TechniqueListTests
    {
        private static JsonElement Technique(string technique) =>
            List().GetProperty("techniques").EnumerateArray()
                .Single(entry => entry.GetProperty("name").GetString() == technique);

        private static JsonElement Values(string technique) => Technique(technique).GetProperty("values");

        private static JsonElement List()
        {
            string file = Path.Combine(FakeShader.PackageRoot(), "tests", "golden", "techniques.json");
            using JsonDocument list = JsonDocument.Parse(File.ReadAllText(file));
            return list.RootElement.Clone();
        }

        // The technique's entries in the list, by what they compute.
        [TestCase(ShadowTechnique.Tent3x3, "tent-3")]
        [TestCase(ShadowTechnique.Tent3x3, "tent-3-plane")]
        [TestCase(ShadowTechnique.Tent5x5, "tent-5")]
        [TestCase(ShadowTechnique.Tent5x5, "tent-5-plane")]
        [TestCase(ShadowTechnique.Tent5x5, "screen-tent-5")]
        [TestCase(ShadowTechnique.Tent7x7, "tent-7")]
        [TestCase(ShadowTechnique.Tent7x7, "tent-7-plane")]
        [TestCase(ShadowTechnique.Pcss, "pcss-angular-24-16")]
        [TestCase(ShadowTechnique.Pcss, "screen-pcss-angular-24-16")]
        [TestCase(ShadowTechnique.PcssPoisson, "pcss-poisson-32")]
        [TestCase(ShadowTechnique.PcssHdrp, "pcss-angular-24-16-hdrp")]
        public void ReportsCallATechniqueAsTheInspectorDoes(ShadowTechnique technique, string entry)
        {
            string title = List().GetProperty("techniques").EnumerateArray()
                .Single(one => one.GetProperty("name").GetString() == entry).GetProperty("title").GetString();
            Assert.That(title, Does.Match("^" + Regex.Escape(TechniqueName.Of(technique)) + "( [0-9o]|,|$)"));
        }

        [Test]
        public void APresetsTitleNamesItsTechnique()
        {
            foreach (QualityPreset preset in Enum.GetValues(typeof(QualityPreset)))
            {
                if (preset == QualityPreset.Custom) continue;
                string title = List().GetProperty("techniques").EnumerateArray()
                    .Single(one => one.GetProperty("name").GetString() == "preset-" + preset.ToString().ToLowerInvariant())
                    .GetProperty("title").GetString();
                string name = TechniqueName.Of(ShadowPresets.Options(preset).technique);
                Assert.That(title, Does.StartWith("Preset " + preset + ": " + name));
            }
        }

        private static float Value(string technique, string field) => Values(technique).GetProperty(field).GetSingle();

        [TestCase("preset-high")]
        [TestCase("preset-ultra")]
        public void TheMaskIsTheStudys(string preset)
        {
            Assert.That(MaskParameters.Default.maskFilterTexels, Is.EqualTo(Value(preset, "maskFilterTexels")));
            Assert.That((float)MaskParameters.Default.maskLargestRadius, Is.EqualTo(Value(preset, "maskLargestRadius")));
            // The pass takes the cap of the filter for it.
            Assert.That(Value(preset, "maskPenumbraMetres"), Is.EqualTo(Value(preset, "maxPenumbraMetres")));
        }

        [Test]
        public void TheDenoiserIsTheStudys()
        {
            Assert.That((float)DenoiseParameters.Default.denoiseRadius, Is.EqualTo(Value("screen-pcss-angular-24-16-denoised", "denoiseRadius")));
            Assert.That(DenoiseParameters.Default.planeTolerance, Is.EqualTo(Value("screen-pcss-angular-24-16-denoised", "planeTolerance")));
            Assert.That(DenoiseParameters.Default.noiseAmplitude, Is.EqualTo(Value("screen-pcss-angular-24-16-denoised", "noiseAmplitude")));
        }

        [Test]
        public void ContactShadowsAreTheStudys()
        {
            ScreenTraceParameters parameters = ScreenTraceParameters.Default;
            foreach (System.Reflection.FieldInfo field in typeof(ScreenTraceParameters).GetFields()
                         .Where(field => !field.IsStatic))
                Assert.That(Convert.ToSingle(field.GetValue(parameters)), Is.EqualTo(Value("screen-high-trace", field.Name)),
                            field.Name);
            ShadowOptions options = ShadowPresets.Options(QualityPreset.High);
            options.contactShadowMetres = parameters.traceLengthMetres;
            JsonElement[] passes = Technique("screen-high-trace").GetProperty("passes").EnumerateArray().ToArray();
            Assert.That(ShadowChain.Of(options).Steps.Select(step => step.pass.program),
                        Is.EqualTo(passes.Select(pass => pass.GetProperty("program").GetString())));
            Assert.That(options.ContactShadows().Vector0, Is.EqualTo(parameters.Vector0));
        }

        [TestCase(FarShadowMode.HeightMap, false, "pcss-angular-24-16-far-heights")]
        [TestCase(FarShadowMode.HeightMap, true, "pcss-angular-24-16-far-heights-clouds")]
        [TestCase(FarShadowMode.HorizonAngles, false, "pcss-angular-24-16-far-horizon")]
        [TestCase(FarShadowMode.HorizonAngles, true, "pcss-angular-24-16-far-horizon-clouds")]
        [TestCase(FarShadowMode.Off, true, "pcss-angular-24-16-clouds")]
        public void FarShadowsAreTheStudys(FarShadowMode mode, bool clouds, string technique)
        {
            var settings = new FarShadowsSettings();
            void HasItsValues(object parameters)
            {
                foreach (System.Reflection.FieldInfo field in parameters.GetType().GetFields().Where(field => !field.IsStatic))
                    Assert.That(Convert.ToSingle(field.GetValue(parameters)), Is.EqualTo(Value(technique, field.Name)),
                                field.Name);
            }
            HasItsValues(settings.parameters);
            if (clouds) HasItsValues(settings.cloudLayer);
            ShadowOptions options = ShadowPresets.Options(QualityPreset.Reference);  // PCSS without a mask
            options.farShadows = mode;
            options.clouds = clouds;
            JsonElement[] passes = Technique(technique).GetProperty("passes").EnumerateArray().ToArray();
            Assert.That(ShadowChain.Of(options).Steps.Select(step => step.pass.program).Except(
                            new[] { "DenoiseHorizontal", "DenoiseVertical" }),
                        Is.EquivalentTo(passes.Select(pass => pass.GetProperty("program").GetString())));
        }

        private static IEnumerable<QualityPreset> Presets() =>
            Enum.GetValues(typeof(QualityPreset)).Cast<QualityPreset>().Where(preset => preset != QualityPreset.Custom);

        /// <summary>What is drawn is the graph that was measured: its passes, their targets and what they read.</summary>
        [TestCaseSource(nameof(Presets))]
        public void APresetsPassesAreTheStudys(QualityPreset preset)
        {
            JsonElement technique = Technique("preset-" + preset.ToString().ToLowerInvariant());
            JsonElement[] passes = technique.GetProperty("passes").EnumerateArray().ToArray();
            var textures = technique.GetProperty("textures").EnumerateArray()
                .ToDictionary(texture => texture.GetProperty("name").GetString());
            ShadowChain chain = ShadowChain.Of(ShadowPresets.Options(preset));
            Assert.That(chain.Steps.Select(step => step.pass.program),
                        Is.EqualTo(passes.Select(pass => pass.GetProperty("program").GetString())));
            for (int i = 0; i < passes.Length; ++i)
            {
                string target = passes[i].GetProperty("writes")[0].GetString();
                ChainTexture slot = chain.Slots[chain.Steps[i].Target];
                Assert.That(slot.divisor, Is.EqualTo(textures[target].GetProperty("divisor").GetInt32()), target);
                Assert.That(slot.extent.ToString().ToLowerInvariant(),
                            Is.EqualTo(textures[target].GetProperty("extent").GetString()), target);
                Assert.That(slot.format, Is.EqualTo(GraphicsFormat.R8_UNorm), target);
                Assert.That(textures[target].GetProperty("format").GetString(), Is.EqualTo("r8"), target);
                JsonProperty[] reads = passes[i].GetProperty("reads").EnumerateObject().ToArray();
                Assert.That(chain.Steps[i].pass.reads.Select(read => read.property),
                            Is.EqualTo(reads.Select(read => read.Name)), target);
                IEnumerable<int> writers = reads.Select(read => Array.FindIndex(
                    passes, pass => pass.GetProperty("writes")[0].GetString() == read.Value.GetString()));
                Assert.That(chain.Steps[i].reads.Select(read => read.index),
                            Is.EqualTo(writers.Select(writer => chain.Steps[writer].Target)), target);
            }
        }

        [Test]
        public void TheShadersPassesAreTheChains()
        {
            string shader = File.ReadAllText(
                Path.Combine(FakeShader.PackageRoot(), "Shaders", "PenumbraShadows.shader"));
            var options = ShadowPresets.Options(QualityPreset.Ultra);
            options.halfResolution = true;
            foreach (ChainStep step in ShadowChain.Of(options).Steps)
                Assert.That(shader, Does.Contain("Name \"" + step.pass.program + "\""));
            foreach (string keyword in TechniqueTable.Keywords.Where(name => name != null))
                Assert.That(shader, Does.Contain(" " + keyword));
        }
    }
}
