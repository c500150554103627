namespace Penumbra.Tests;

/// <summary>
/// Techniques whose filters read maps that passes make from the shadow map, and what stands in for them.
/// </summary>
public sealed class MapTechniqueTests : FeatureTests
{
    [SetUp]
    public void SetUp()
    {
        feature.Settings.preset = QualityPreset.Custom;
        feature.Settings.custom.mask = false;
    }

    private static IEnumerable<ShadowTechnique> Every() =>
        Enum.GetValues(typeof(ShadowTechnique)).Cast<ShadowTechnique>();

    private static bool DrawsVisibility(ShadowTechnique technique) =>
        new ShadowOptions { technique = technique }.DrawsVisibility;

    private static IEnumerable<ShadowTechnique> WithMaps() =>
        Every().Where(technique => technique.Entry().formats[0].graph != null && !DrawsVisibility(technique));

    private static IEnumerable<ShadowTechnique> WithResolve() =>
        Every().Where(technique => !DrawsVisibility(technique));

    private FakeDevice.DrawCall Resolve(ShadowTechnique technique, MapFormat format = MapFormat.Bits32)
    {
        feature.Settings.custom.technique = technique;
        feature.Settings.custom.mapFormat = format;
        Render();
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None), feature.MissingPass);
        return Draw("Resolve");
    }

    [TestCaseSource(nameof(WithMaps))]
    public void TheMapsOfEachCascadeComeBeforeTheFilterThatReadsThem(ShadowTechnique technique)
    {
        FakeDevice.DrawCall resolve = Resolve(technique);
        TechniqueGraph graph = technique.Entry().formats[0].graph;
        string[] drawn = Passes();
        Assert.That(drawn.Distinct(), Is.EqualTo(graph.passes.Select(pass => pass.program).Append("Resolve")));
        Assert.That(drawn.Count(pass => pass == graph.passes[0].program), Is.EqualTo(4), "cascades");
        Assert.That(resolve.Keywords, Is.EqualTo(new[] { technique.Entry().keyword }));
        foreach (GraphBinding texture in graph.filterTextures)
        {
            Assert.That(resolve.Textures, Contains.Key(texture.property));
            Assert.That(resolve.Textures[texture.property], Is.Not.EqualTo(resolve.Target));
            Assert.That(urp.Device.Textures[texture.property], Is.EqualTo(resolve.Textures[texture.property]),
                        "forward shaders find it, too");
        }
        Assert.That(feature.Replaced, Is.Null);
    }

    [TestCase(ShadowTechnique.Vsm, GraphicsFormat.R32G32_SFloat, GraphicsFormat.R16G16_SFloat)]
    [TestCase(ShadowTechnique.Esm, GraphicsFormat.R32_SFloat, GraphicsFormat.R16_SFloat)]
    [TestCase(ShadowTechnique.Evsm, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.R16G16B16A16_SFloat)]
    [TestCase(ShadowTechnique.Msm, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.R16G16B16A16_UNorm)]
    [TestCase(ShadowTechnique.VssmMips, GraphicsFormat.R32G32_SFloat, GraphicsFormat.R16G16_UNorm)]
    public void TheFormatOfTheMapsIsChosen(ShadowTechnique technique, GraphicsFormat of32, GraphicsFormat of16)
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.Medium);
        options.technique = technique;
        foreach (MapFormat format in new[] { MapFormat.Bits32, MapFormat.Bits16 })
        {
            options.mapFormat = format;
            ShadowChain chain = ShadowChain.Of(options);
            ChainTexture map = chain.Slots[chain.Globals.Single().texture.index];
            Assert.That(map.format, Is.EqualTo(format == MapFormat.Bits32 ? of32 : of16));
            Assert.That(map.kept, "a cascade that is not drawn anew keeps its tile");
            Assert.That(map.filtered);
        }
    }

    [Test]
    public void WithoutTheFormatOf32BitsThatOf16IsDrawnAsItIsMeasured()
    {
        SystemInfo.Unsupported = GraphicsFormat.R32G32_SFloat;
        var precision = Vector(Resolve(ShadowTechnique.Vsm), "_PenumbraVarianceParameters0");
        Assert.That(precision.y, Is.EqualTo(0.00048828125f));
        Assert.That(feature.Replaced, Is.EqualTo("this device cannot draw to textures of R32G32_SFloat"));
        Assert.That(feature.Drawn.mapFormat, Is.EqualTo(MapFormat.Bits16));
    }

    [Test]
    public void AMapThatIsNotFilteredIsNotRead()
    {
        SystemInfo.Unfiltered.Add(GraphicsFormat.R32G32_SFloat);
        Resolve(ShadowTechnique.Vsm);
        Assert.That(feature.Replaced, Is.EqualTo("this device cannot filter textures of R32G32_SFloat"));
        Assert.That(feature.Drawn.mapFormat, Is.EqualTo(MapFormat.Bits16));
    }

    private void ExpectTheFallback(ShadowTechnique technique, string reason)
    {
        FakeDevice.DrawCall resolve = Resolve(technique);
        Assert.That(Passes(), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(resolve.Keywords, Is.EqualTo(new[] { "_PENUMBRA_TENT_7X7" }));
        Assert.That(feature.Replaced, Does.Contain(reason));
        Assert.That(feature.Asked.technique, Is.EqualTo(technique));
        Assert.That(feature.Drawn.technique, Is.EqualTo(ShadowTechnique.Tent7x7));
    }

    [Test]
    public void WithoutEitherFormatTheFallbackIsDrawn()
    {
        SystemInfo.Unfiltered.Add(GraphicsFormat.R32G32_SFloat);
        SystemInfo.Unfiltered.Add(GraphicsFormat.R16G16_SFloat);
        ExpectTheFallback(ShadowTechnique.Vsm, "cannot filter textures of R32G32_SFloat");
    }

    [TestCaseSource(nameof(WithMaps))]
    public void OnOpenGlTheFallbackIsDrawn(ShadowTechnique technique)
    {
        SystemInfo.Device = GraphicsDeviceType.OpenGLES3;
        ExpectTheFallback(technique, "OpenGL does not define");
    }

    [Test]
    public void WithoutKernelsTheFallbackIsDrawn()
    {
        FakeShader.Sums.Kernels[0].IsSupported = false;
        ExpectTheFallback(ShadowTechnique.Vssm, "cannot run kernel 'SumRows'");
    }

    [TestCase(ShadowTechnique.SingleLoopMips)]
    [TestCase(ShadowTechnique.VssmMips)]
    [TestCase(ShadowTechnique.EvsmMips)]
    public void BelowTarget45TheFallbackIsDrawn(ShadowTechnique technique)
    {
        SystemInfo.graphicsShaderLevel = 35;
        ExpectTheFallback(technique, "shader model 4.5");
    }

    [Test]
    public void TheShaderAsksForTarget45WhereTheTechniqueDoes() =>
        Assert.That(FakeShader.KeywordsOfTarget45(),
                    Is.EquivalentTo(Every().Where(technique => technique.Entry().needsTarget45)
                                        .Select(technique => technique.Entry().keyword).Distinct()));

    // The values are those of no measured technique.
    private static ShadowOptions Odd() => new ShadowOptions
    {
        angularDiameterDegrees = 2.0f, blockerSamples = 5, filterSamples = 6, softnessCapMetres = 3.0f,
        minFilterTexels = 3.5f, lightBleeding = 0.7f, mapBlurTexels = 3.25f, rays = 3, samplesPerRay = 4,
        discRadiusMetres = 0.75f,
    };

    // The struct of a uniform, with the values of a measured technique.
    private static Vector4 Packed(string uniform, JsonElement values)
    {
        string name = uniform.Substring("_Penumbra".Length, uniform.Length - "_Penumbra".Length - 1);
        Type type = typeof(ShadowOptions).Assembly.GetType("Penumbra." + name, true);
        object parameters = Activator.CreateInstance(type);
        foreach (FieldInfo field in type.GetFields().Where(field => !field.IsStatic))
        {
            float value = values.GetProperty(field.Name).GetSingle();
            field.SetValue(parameters, Convert.ChangeType(value, field.FieldType));
        }
        return (Vector4)type.GetProperty("Vector" + uniform.Last()).GetValue(parameters);
    }

    [TestCase(ShadowTechnique.Vsm, MapFormat.Bits32, "variance-32")]
    [TestCase(ShadowTechnique.Vsm, MapFormat.Bits16, "variance-16")]
    [TestCase(ShadowTechnique.Esm, MapFormat.Bits32, "exponential-32")]
    [TestCase(ShadowTechnique.Esm, MapFormat.Bits16, "exponential-16")]
    [TestCase(ShadowTechnique.EsmLog, MapFormat.Bits32, "log-exponential-16")]
    [TestCase(ShadowTechnique.Evsm, MapFormat.Bits32, "exponential-variance-32")]
    [TestCase(ShadowTechnique.Evsm, MapFormat.Bits16, "exponential-variance-16")]
    [TestCase(ShadowTechnique.Msm, MapFormat.Bits32, "moments-32")]
    [TestCase(ShadowTechnique.Msm, MapFormat.Bits16, "moments-16")]
    [TestCase(ShadowTechnique.SingleLoop, MapFormat.Bits32, "single-loop-32")]
    [TestCase(ShadowTechnique.SingleLoopMinMax, MapFormat.Bits32, "single-loop-32-minmax")]
    [TestCase(ShadowTechnique.SingleLoopMips, MapFormat.Bits32, "single-loop-32-mips")]
    [TestCase(ShadowTechnique.SingleLoopPlanes, MapFormat.Bits32, "single-loop-32-planes")]
    [TestCase(ShadowTechnique.Vssm, MapFormat.Bits32, "vssm-sat-32")]
    [TestCase(ShadowTechnique.VssmMips, MapFormat.Bits32, "vssm-mip-32")]
    [TestCase(ShadowTechnique.VssmMips, MapFormat.Bits16, "vssm-mip-16")]
    [TestCase(ShadowTechnique.Mssm, MapFormat.Bits32, "mssm-sat-32")]
    [TestCase(ShadowTechnique.MssmMips, MapFormat.Bits32, "mssm-mip-16")]
    [TestCase(ShadowTechnique.EvsmMips, MapFormat.Bits32, "evsm-mip")]
    [TestCase(ShadowTechnique.Smrt, MapFormat.Bits32, "unreal-smrt-7-8")]
    [TestCase(ShadowTechnique.PcssGodot, MapFormat.Bits32, "godot-pcss-8")]
    [TestCase(ShadowTechnique.DpcfFilament, MapFormat.Bits32, "filament-dpcf-12")]
    [TestCase(ShadowTechnique.PcssFilament, MapFormat.Bits32, "filament-pcss-16-16")]
    [TestCase(ShadowTechnique.TiledPcss, MapFormat.Bits32, "tiled-pcss")]
    [TestCase(ShadowTechnique.PcssBounded, MapFormat.Bits32, "pcss-bounded-16-16")]
    public void PassesAndFiltersAreToldWhatIsMeasured(ShadowTechnique technique, MapFormat format, string measured)
    {
        ShadowOptions options = Odd();
        options.technique = technique;
        options.mapFormat = format;
        technique.Entry().SetMeasured(ref options);
        Use(options);
        Render();
        Assert.That((feature.LastSkip, feature.Replaced), Is.EqualTo((SkipReason.None, (string)null)));
        var told = new FakeDevice();
        var commands = new CommandBuffer();
        foreach (ParameterVector vector in options.Format.parameters) vector.SetGlobal(commands, options);
        told.Play(commands);
        Assert.That(told.Uniforms, Is.Not.Empty);
        JsonElement values = Measured.Named("techniques", measured).GetProperty("values");
        foreach (string uniform in told.Uniforms.Keys)
        {
            Assert.That(told.Uniforms[uniform], Is.EqualTo(Packed(uniform, values)), uniform);
            Assert.That(urp.Device.Uniforms[uniform], Is.EqualTo(told.Uniforms[uniform]), uniform);
        }
    }

    /// <summary>Forward shaders may use a filter without maps whatever the feature's technique is.</summary>
    [Test]
    public void FiltersWithoutMapsAreAlwaysTold() =>
        Assert.That(Resolve(ShadowTechnique.Pcss).Uniforms.Keys,
                    Is.SupersetOf(new[]
                    {
                        "_PenumbraUnrealSmrtParameters0", "_PenumbraGodotPcssParameters0", "_PenumbraFilamentParameters0",
                        "_PenumbraSingleLoopParameters0",
                    }));

    /// <summary>The shader fails to compile for a while, as it does while a file is edited.</summary>
    [Test]
    public void AShaderThatCompilesAgainIsDrawnWithAfterItsImport()
    {
        feature.Settings.custom.technique = ShadowTechnique.TiledPcss;
        ComputeShader.Kernel[] kernels = FakeShader.TiledPcss.Kernels.ToArray();
        FakeShader.TiledPcss.Kernels.Clear();
        Render();
        Assert.That(feature.Replaced, Does.Contain("does not compile"));
        FakeShader.TiledPcss.Kernels.AddRange(kernels);
        Import("Assets/Lake.png");
        Render();
        Assert.That(feature.Replaced, Is.Not.Null, "no shader");
        Import("Packages/com.penumbra.shadows/Shaders/PenumbraTiledPcss.compute");
        Render();
        Assert.That(feature.Replaced, Is.Null);
        Assert.That(feature.Drawn.technique, Is.EqualTo(ShadowTechnique.TiledPcss));
    }

    // Unity looks for the method by this name and these parameters.
    private static void Import(string path)
    {
        typeof(ShaderImports).GetMethod("OnPostprocessAllAssets", BindingFlags.Static | BindingFlags.NonPublic).Invoke(null, new object[] { new[] { path }, new string[0], new string[0], new string[0] });
    }

    [TestCaseSource(nameof(WithResolve))]
    public void OfTheTechniquesStructsItsOwnValuesWin(ShadowTechnique technique)
    {
        feature.Settings.custom.blockerSamples = 5;
        feature.Settings.custom.filterSamples = 7;
        bool dpcf = technique == ShadowTechnique.DpcfFilament;
        var filament = Vector(Resolve(technique), "_PenumbraFilamentParameters0");
        Assert.That(filament.x, Is.EqualTo(5.0f));
        Assert.That(filament.y, Is.EqualTo(dpcf ? 16.0f : 7.0f));
    }
}
