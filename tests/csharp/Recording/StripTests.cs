using UnityEditor.Rendering;

namespace Penumbra.Tests;

/// <summary>A player contains those of the shader's programs that frames draw with, and no other.</summary>
public sealed class StripTests : FeatureTests
{
    private static string Text(string pass, IEnumerable<string> keywords) =>
        string.Join(" ", keywords.OrderBy(name => name, StringComparer.Ordinal).Prepend(pass));

    private static List<ShaderCompilerData> Data(IEnumerable<HashSet<string>> sets,
                                                 ShaderCompilerPlatform platform = ShaderCompilerPlatform.Vulkan) =>
        sets.Select(set => new ShaderCompilerData
        {
            shaderKeywordSet = new ShaderKeywordSet { Enabled = set }, shaderCompilerPlatform = platform,
        }).ToList();

    private (Shader shader, Dictionary<string, List<HashSet<string>>> variants)[] Shaders() => new[]
    {
        (FakeShader.Screen, FakeShader.FragmentVariants()), (FakeShader.Maps, FakeShader.MapVariants()),
        (FakeShader.Far, FakeShader.FarVariants()),
    };

    private Dictionary<string, List<HashSet<string>>> AllVariants() =>
        Shaders().SelectMany(one => one.variants).ToDictionary(pass => pass.Key, pass => pass.Value);

    private static void Strip(ChainPrograms programs, Shader shader, string pass, List<ShaderCompilerData> data) =>
        ChainShaderStripper.Strip(programs, shader, ChainShaderStripper.AssetOf(shader), pass, data);

    /// <summary>Fragment programs of one shader: passes with their keywords.</summary>
    private static IEnumerable<string> Kept(ChainPrograms programs, Shader one,
                                            Dictionary<string, List<HashSet<string>>> variants)
    {
        foreach (KeyValuePair<string, List<HashSet<string>>> pass in variants)
        {
            List<ShaderCompilerData> data = Data(pass.Value);
            Strip(programs, one, pass.Key, data);
            foreach (ShaderCompilerData variant in data) yield return Text(pass.Key, variant.shaderKeywordSet.Enabled);
        }
    }

    /// <summary>The programs of all shaders, and the kernels.</summary>
    private string[] Kept(ChainPrograms programs)
    {
        var kept = new List<string>();
        foreach ((Shader one, Dictionary<string, List<HashSet<string>>> variants) in Shaders())
            kept.AddRange(Kept(programs, one, variants));
        foreach (ComputeShader one in new[] { FakeShader.Sums, FakeShader.TiledPcss })
            foreach (ComputeShader.Kernel kernel in one.Kernels)
                kept.AddRange(KeptOfKernel(programs, one, kernel.Name, bothEyes: false));
        return kept.ToArray();
    }

    private static IEnumerable<string> KeptOfKernel(ChainPrograms programs, ComputeShader shader, string kernel, bool bothEyes,
                                                    ShaderCompilerPlatform platform = ShaderCompilerPlatform.Vulkan)
    {
        // Each of its keywords is in a line of its own.
        IEnumerable<HashSet<string>> sets = Enumerable.Range(0, 1 << shader.KeywordNames.Count).Select(
            bits => shader.KeywordNames.Where((name, at) => (bits >> at & 1) != 0).ToHashSet());
        List<ShaderCompilerData> data = Data(sets, platform);
        ChainKernelStripper.Strip(programs, shader, ChainShaderStripper.AssetOf((UnityEngine.Object)shader), kernel, data,
                                  bothEyes);
        return data.Select(variant => Text(Kernel(kernel), variant.shaderKeywordSet.Enabled));
    }

    // A kernel may have the name of a pass.
    private static string Kernel(string name) => "kernel " + name;

    // The program of a draw: its pass minds those of the draw's keywords that it declares.
    private static string Program(FakeDevice.DrawCall draw, Dictionary<string, List<HashSet<string>>> variants)
    {
        if (draw.Groups != null)
            return Text(Kernel(draw.Pass), FakeShader.TiledPcss.Kernels.Any(kernel => kernel.Name == draw.Pass)
                                               ? draw.Keywords.Intersect(FakeShader.TiledPcss.KeywordNames) : new string[0]);
        IEnumerable<string> declared = variants[draw.Pass].SelectMany(set => set);
        return Text(draw.Pass, draw.Keywords.Intersect(declared));
    }

    // The programs that are drawn on devices that can make the conservative mask, run kernels and gather, and on
    // others.
    private string[] Drawn(PenumbraShadowsSettings settings)
    {
        IEnumerable<string> drawn = DrawnHere(settings);
        SystemInfo.Device = GraphicsDeviceType.OpenGLES3;
        drawn = drawn.Union(DrawnAnew(settings));
        SystemInfo.Device = GraphicsDeviceType.Vulkan;
        SystemInfo.supportsComputeShaders = false;
        drawn = drawn.Union(DrawnAnew(settings));
        SystemInfo.supportsComputeShaders = true;
        SystemInfo.graphicsShaderLevel = 35;
        drawn = drawn.Union(DrawnAnew(settings));
        SystemInfo.graphicsShaderLevel = 50;
        DisposeOfTheFeature();
        MakeTheFeature();
        return drawn.ToArray();
    }

    private string[] DrawnAnew(PenumbraShadowsSettings settings)
    {
        DisposeOfTheFeature();
        MakeTheFeature();
        return DrawnHere(settings);
    }

    private string[] DrawnHere(PenumbraShadowsSettings settings)
    {
        feature.Settings.preset = settings.preset;
        feature.Settings.custom = settings.custom;
        feature.Settings.angularDiameterDegrees = settings.angularDiameterDegrees;
        Render();
        Dictionary<string, List<HashSet<string>>> variants = AllVariants();
        return urp.Device.Draws.Select(draw => Program(draw, variants)).Distinct().ToArray();
    }

    private static IEnumerable<PenumbraShadowsSettings> EverySetting()
    {
        foreach (QualityPreset preset in Enum.GetValues(typeof(QualityPreset)))
            foreach (float degrees in new[] { 0.0f, AngularDiameter.SunDegrees })
                yield return new PenumbraShadowsSettings { preset = preset, angularDiameterDegrees = degrees };
        foreach (ShadowTechnique technique in Enum.GetValues(typeof(ShadowTechnique)))
            for (int bits = 0; bits < 32; ++bits)
            {
                ShadowOptions options = ShadowPresets.Options(QualityPreset.Custom);
                options.technique = technique;
                options.mask = (bits & 1) != 0;
                options.halfResolution = (bits & 2) != 0;
                options.denoise = (bits & 4) != 0;
                options.conservativeMask = (bits & 16) != 0;
                if ((bits & 8) != 0) options.angularDiameterDegrees = 0.0f;
                yield return new PenumbraShadowsSettings { preset = QualityPreset.Custom, custom = options };
            }
    }

    private static (PenumbraShadowsSettings settings, string[] drawn)[] everyFrame;

    // Frames with each setting, which two tests look at.
    private (PenumbraShadowsSettings settings, string[] drawn)[] EveryFrame() =>
        everyFrame ??= EverySetting().Select(settings => (settings, Drawn(settings))).ToArray();

    [Test]
    public void WhatAFrameDrawsWithIsKeptAndNothingElse()
    {
        foreach ((PenumbraShadowsSettings settings, string[] drawn) in EveryFrame())
        {
            ChainPrograms programs = ChainPrograms.Of(new[] { settings }, new PenumbraShadowsVolume[0]);
            Assert.That(Kept(programs), Is.EquivalentTo(drawn), settings.preset + " " + string.Join(" ", drawn));
        }
    }

    /// <summary>
    /// Documentation~/presets.md shows that file; the program writes it from the technique list. The file is about
    /// the feature's shader alone, without the kernels.
    /// </summary>
    [Test]
    public void WhatThePageSaysOfEachPresetIsWhatIsKept()
    {
        string file = Path.Combine(FakeShader.PackageRoot(), "Documentation~", "variants", "presets.json");
        using JsonDocument page = JsonDocument.Parse(File.ReadAllText(file));
        Assert.That(page.RootElement.GetProperty("shader").GetString(), Is.EqualTo(PenumbraShadows.ShaderName));
        Assert.That(page.RootElement.GetProperty("programs").GetInt32(),
                    Is.EqualTo(FakeShader.FragmentVariants().Values.Sum(sets => sets.Count)));
        JsonElement presets = page.RootElement.GetProperty("presets");
        Assert.That(presets.GetArrayLength(), Is.EqualTo((int)QualityPreset.Custom));
        foreach (JsonElement preset in presets.EnumerateArray())
        {
            string name = preset.GetProperty("name").GetString().Substring("preset-".Length);
            var settings = new PenumbraShadowsSettings { preset = Enum.Parse<QualityPreset>(name, true) };
            IEnumerable<string> programs = preset.GetProperty("programs").EnumerateArray().Select(Program);
            ChainPrograms kept = ChainPrograms.Of(new[] { settings }, new PenumbraShadowsVolume[0]);
            Assert.That(Kept(kept, FakeShader.Screen, FakeShader.FragmentVariants()), Is.EquivalentTo(programs), name);
        }
    }

    private static string Program(JsonElement program) =>
        Text(program.GetProperty("pass").GetString(),
             program.GetProperty("keywords").EnumerateArray().Select(keyword => keyword.GetString()));

    // The vertex programs know no fragment keyword: one is there, and it is for all.
    [Test]
    public void VertexProgramsOfTheSamePassesAreKept()
    {
        foreach ((PenumbraShadowsSettings settings, string[] frame) in EveryFrame())
        {
            ChainPrograms programs = ChainPrograms.Of(new[] { settings }, new PenumbraShadowsVolume[0]);
            var kept = new List<string>();
            foreach ((Shader one, Dictionary<string, List<HashSet<string>>> variants) in Shaders())
                foreach (string pass in variants.Keys)
                {
                    List<ShaderCompilerData> data = Data(new[] { new HashSet<string>() });
                    Strip(programs, one, pass, data);
                    if (data.Count > 0) kept.Add(pass);
                }
            IEnumerable<string> drawn = frame.Select(program => program.Split(' ')[0]).Distinct();
            Assert.That(kept, Is.EquivalentTo(drawn.Where(pass => pass != "kernel")));
        }
    }

    private static ChainPrograms Programs(QualityPreset preset) =>
        ChainPrograms.Of(new[] { new PenumbraShadowsSettings { preset = preset } }, new PenumbraShadowsVolume[0]);

    private static readonly object[] WithoutKernels =
    {
        ShaderCompilerPlatform.GLES3x, ShaderCompilerPlatform.OpenGLCore,
#if UNITY_6000_0_OR_NEWER
        ShaderCompilerPlatform.WebGPU,
#endif
    };

    [TestCaseSource(nameof(WithoutKernels))]
    public void ApisOnWhichNoKernelRunsHaveNone(object platform) =>
        Assert.That(KeptOfKernel(Programs(QualityPreset.Ultra), FakeShader.TiledPcss, "FilterTiles", true,
                                 (ShaderCompilerPlatform)platform), Is.Empty);

    [Test]
    public void KernelsForBothEyesAreKeptBesideThoseForOneInAProjectWithXr()
    {
        const string eyes = " _PENUMBRA_BOTH_EYES";
        string[] Kept(QualityPreset preset, string kernel, bool xr) =>
            KeptOfKernel(Programs(preset), FakeShader.TiledPcss, kernel, xr).ToArray();
        // The presets draw at half resolution and at full.
        foreach ((QualityPreset preset, string last, string other) in new[]
                 {
                     (QualityPreset.Low, "Upsample", "SmoothFar"), (QualityPreset.Ultra, "SmoothFar", "Upsample"),
                 })
        {
            string program = "kernel " + last;
            Assert.That(Kept(preset, last, false), Is.EqualTo(new[] { program }));
            Assert.That(Kept(preset, last, true), Is.EquivalentTo(new[] { program, program + eyes }));
            Assert.That(Kept(preset, other, true), Is.Empty);
        }
    }

    /// <summary>The feature's asset refers to the compute shaders of all techniques.</summary>
    [Test]
    public void KernelsOfOthersAreLeftAloneAndThoseOfNoTechniqueGo()
    {
        List<ShaderCompilerData> data = Data(new[] { new HashSet<string>() });
        new ChainKernelStripper().OnProcessComputeShader(new ComputeShader { name = "Other" }, "Main", data);
        Assert.That(data, Has.Count.EqualTo(1));
        new ChainKernelStripper().OnProcessComputeShader(FakeShader.Sums, "SumRows", data);
        Assert.That(data, Is.Empty, "a project without the feature");
    }

    // Stereo and the like multiply programs too, and are not ours to strip.
    [Test]
    public void KeywordsOfOthersDoNotDecide()
    {
        ChainPrograms low = ChainPrograms.Of(new[] { new PenumbraShadowsSettings { preset = QualityPreset.Low } },
                                             new PenumbraShadowsVolume[0]);
        List<ShaderCompilerData> data = Data(FakeShader.FragmentVariants()["Resolve"].SelectMany(
            set => new[] { set, new HashSet<string>(set.Append("STEREO_INSTANCING_ON")) }));
        Strip(low, FakeShader.Screen, "Resolve", data);
        Assert.That(data.Select(variant => Text("Resolve", variant.shaderKeywordSet.Enabled)),
                    Is.EqualTo(new[]
                    {
                        "Resolve _PENUMBRA_TENT_7X7", "Resolve STEREO_INSTANCING_ON _PENUMBRA_TENT_7X7",
                        "Resolve _PENUMBRA_PCSS_BOUNDED", "Resolve STEREO_INSTANCING_ON _PENUMBRA_PCSS_BOUNDED",
                    }));
    }

    [Test]
    public void ShadersOfOthersAreLeftAlone()
    {
        List<ShaderCompilerData> data = Data(new[] { new HashSet<string>() });
        new ChainShaderStripper().OnProcessShader(new Shader { name = "Somebody/Else" }, default, data);
        Assert.That(data, Has.Count.EqualTo(1));
    }

    // FindAssets finds nothing here: a project without the feature.
    [Test]
    public void WithoutAFeatureTheShaderIsEmpty()
    {
        List<ShaderCompilerData> data = Data(FakeShader.FragmentVariants()["Resolve"]);
        new ChainShaderStripper().OnProcessShader(FakeShader.Screen, default, data);
        Assert.That(data, Is.Empty);
    }
}
