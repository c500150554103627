using System.Text.RegularExpressions;

namespace Penumbra.Tests;

/// <summary>The passes are told the values that the study measures them with.</summary>
public sealed class TechniqueListTests : FeatureTests
{
    private static JsonElement Technique(string technique) => Measured.Named("techniques", technique);

    private static JsonElement Values(string technique) => Technique(technique).GetProperty("values");

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
    [TestCase(ShadowTechnique.TiledPcss, "tiled-pcss")]
    public void ReportsCallATechniqueAsTheInspectorDoes(ShadowTechnique technique, string entry)
    {
        string title = Technique(entry).GetProperty("title").GetString();
        Assert.That(title, Does.Match("^" + Regex.Escape(TechniqueName.Of(technique)) + "( [0-9o]|,|$)"));
    }

    [TestCaseSource(nameof(Presets))]
    public void ReportsCallAPresetByItsName(QualityPreset preset)
    {
        Assert.That(Technique(Named("preset", preset)).GetProperty("title").GetString(), Is.EqualTo("Penumbra " + preset));
        Assert.That(Technique(Named("fallback", preset)).GetProperty("title").GetString(),
                    Is.EqualTo("Fallback of " + preset));
    }

    private static float Value(string technique, string field) => Values(technique).GetProperty(field).GetSingle();

    [Test]
    public void TheMaskIsTheStudys()
    {
        const string masked = "screen-pcss-angular-24-16-masked";
        Assert.That(MaskParameters.Default.maskFilterTexels, Is.EqualTo(Value(masked, "maskFilterTexels")));
        Assert.That((float)MaskParameters.Default.maskLargestRadius, Is.EqualTo(Value(masked, "maskLargestRadius")));
        // The pass takes the cap of the filter for it.
        Assert.That(Value(masked, "maskPenumbraMetres"), Is.EqualTo(Value(masked, "maxPenumbraMetres")));
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
        foreach (FieldInfo field in typeof(ScreenTraceParameters).GetFields()
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
            foreach (FieldInfo field in parameters.GetType().GetFields().Where(field => !field.IsStatic))
                Assert.That(Convert.ToSingle(field.GetValue(parameters)), Is.EqualTo(Value(technique, field.Name)),
                            field.Name);
        }
        HasItsValues(settings.parameters);
        if (clouds) HasItsValues(settings.cloudLayer);
        ShadowOptions options = PresetFallback.Options(QualityPreset.Medium);  // PCSS without a mask
        options.farShadows = mode;
        options.clouds = clouds;
        JsonElement[] passes = Technique(technique).GetProperty("passes").EnumerateArray().ToArray();
        Assert.That(ShadowChain.Of(options).Steps.Select(step => step.pass.program).Except(
                        new[] { "DenoiseHorizontal", "DenoiseVertical" }),
                    Is.EquivalentTo(passes.Select(pass => pass.GetProperty("program").GetString())));
    }

    private static IEnumerable<QualityPreset> Presets() =>
        Enum.GetValues(typeof(QualityPreset)).Cast<QualityPreset>().Where(preset => preset != QualityPreset.Custom);

    private static string Named(string kind, QualityPreset preset) => kind + "-" + preset.ToString().ToLowerInvariant();

    /// <summary>A preset draws the graph that was measured: its passes, their targets and what they read.</summary>
    [TestCaseSource(nameof(Presets))]
    public void APresetsPassesAreTheStudys(QualityPreset preset) =>
        HasPassesOf(Named("preset", preset), ShadowPresets.Options(preset));

    private static readonly Dictionary<string, GraphicsFormat> Formats = new Dictionary<string, GraphicsFormat>
    {
        ["r8"] = GraphicsFormat.R8_UNorm, ["r32f"] = GraphicsFormat.R32_SFloat, ["r32ui"] = GraphicsFormat.R32_UInt,
    };

    private static string[] Programs(string technique) =>
        Technique(technique).GetProperty("passes").EnumerateArray()
            .Select(pass => pass.GetProperty("program").GetString()).ToArray();

    private static void HasPassesOf(string name, in ShadowOptions options)
    {
        JsonElement technique = Technique(name);
        JsonElement[] passes = technique.GetProperty("passes").EnumerateArray().ToArray();
        var textures = technique.GetProperty("textures").EnumerateArray()
            .ToDictionary(texture => texture.GetProperty("name").GetString());
        ShadowChain chain = ShadowChain.Of(options);
        IEnumerable<string> keywords =
            technique.GetProperty("keywords").EnumerateArray().Select(keyword => keyword.GetString());
        // Kernels declare no technique's.
        if (options.DrawsVisibility) keywords = keywords.Append(options.technique.Entry().keyword);
        Assert.That(chain.Keywords, Is.EquivalentTo(keywords), name);
        Assert.That(chain.Steps.Select(step => step.pass.program), Is.EqualTo(Programs(name)), name);
        var placed = new Dictionary<string, int>();
        for (int i = 0; i < passes.Length; ++i)
        {
            ChainStep step = chain.Steps[i];
            Assert.That(step.pass.asset, Is.EqualTo(passes[i].GetProperty("file").GetString()));
            Assert.That(step.pass.runs.ToString().ToLowerInvariant(),
                        Is.EqualTo(passes[i].GetProperty("runs").GetString()));
            JsonProperty[] reads = passes[i].GetProperty("reads").EnumerateObject().ToArray();
            Assert.That(step.pass.reads.Select(read => read.property), Is.EqualTo(reads.Select(read => read.Name)));
            for (int read = 0; read < reads.Length; ++read) IsAt(reads[read].Value.GetString(), step.reads[read]);
            string[] writes = passes[i].GetProperty("writes").EnumerateArray().Select(write => write.GetString())
                .ToArray();
            Assert.That(step.writes.Length, Is.EqualTo(writes.Length), step.pass.program);
            for (int write = 0; write < writes.Length; ++write) IsAt(writes[write], step.writes[write]);
        }
        Assert.That(textures.Keys, Is.SubsetOf(placed.Keys));

        void IsAt(string target, in ChainBinding bound)
        {
            if (placed.TryGetValue(target, out int before)) Assert.That(bound.index, Is.EqualTo(before), target);
            placed[target] = bound.index;
            ChainTexture slot = chain.Slots[bound.index];
            Assert.That(slot.divisor, Is.EqualTo(textures[target].GetProperty("divisor").GetInt32()), target);
            Assert.That(slot.extent.ToString().ToLowerInvariant(),
                        Is.EqualTo(textures[target].GetProperty("extent").GetString()), target);
            Assert.That(slot.format, Is.EqualTo(Formats[textures[target].GetProperty("format").GetString()]), target);
        }
    }

    /// <summary>The kernels are told the values that they were measured with.</summary>
    [TestCaseSource(nameof(Presets))]
    public void WhatAPresetTellsIsTheStudys(QualityPreset preset)
    {
        feature.Settings.preset = preset;
        string name = Named("preset", preset);
        Assert.That(Render(), Is.EqualTo(Programs(name)));
        HasValuesOf(name);
    }

    private void HasValuesOf(string name) =>
        Assert.That(urp.Device.Uniforms["_PenumbraPcssBoundedParameters0"],
                    Is.EqualTo(new Vector4(Value(name, "searchSamples"), Value(name, "filterSamples"),
                                           Value(name, "maxPenumbraMetres"), 0.0f)));

    /// <summary>Without compute shaders, a preset draws what was measured as its fallback.</summary>
    [TestCaseSource(nameof(Presets))]
    public void WhatAPresetFallsBackToIsTheStudys(QualityPreset preset)
    {
        string name = Named("fallback", preset);
        feature.Settings.preset = preset;
        SystemInfo.supportsComputeShaders = false;
        Assert.That(Render(), Is.EqualTo(Programs(name)));
        Assert.That(feature.Replaced, Is.Not.Null);
        HasPassesOf(name, feature.Drawn);
        HasValuesOf(name);
    }

    [Test]
    public void TheShadersPassesAreTheChains()
    {
        string shader = File.ReadAllText(Path.Combine(FakeShader.PackageRoot(), "Shaders", "PenumbraShadows.shader"));
        ShadowOptions options = PresetFallback.Options(QualityPreset.Ultra);
        options.halfResolution = true;
        foreach (ChainStep step in ShadowChain.Of(options).Steps)
            Assert.That(shader, Does.Contain("Name \"" + step.pass.program + "\""));
        foreach (string keyword in ChainKeywords.OfTechniques) Assert.That(shader, Does.Contain(" " + keyword));
    }

    /// <summary>Without its keyword, the pass would filter with another technique and say nothing.</summary>
    [Test]
    public void ThePassThatFiltersDeclaresEveryTechnique()
    {
        string shader = File.ReadAllText(Path.Combine(FakeShader.PackageRoot(), "Shaders", "PenumbraShadows.shader"));
        string text = shader.Substring(shader.IndexOf("Name \"Resolve\""));
        string[] declared = text.Substring(0, text.IndexOf("ENDHLSL")).Split('\n')
            .Where(line => line.Contains("#pragma multi_compile")).SelectMany(line => line.Trim().Split(' ')).ToArray();
        Assert.That(ChainKeywords.OfTechniques.Except(declared), Is.Empty);
    }
}
