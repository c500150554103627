namespace Penumbra.Tests;

/// <summary>Chains that a device cannot run are named, before anything of them is made.</summary>
public sealed class DeviceLimitsTests : EngineTests
{
    private GraphPass pass;
    private List<GraphTexture> textures;

    [SetUp]
    public void SetUp()
    {
        pass = Writing(0);
        pass.program = "Resolve";
        textures = new List<GraphTexture>
        {
            new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm),
        };
    }

    private ShadowChain Chain(params GraphPass[] before)
    {
        var graph = new TechniqueGraph
        {
            name = "graph", textures = textures.ToArray(), passes = before.Append(pass).ToArray(), visibility = 0,
        };
        return new ShadowChain(new[] { graph }, null);
    }

    private static GraphPass Writing(params int[] targets) => new GraphPass
    {
        asset = PenumbraShadows.ShaderFile, program = "Means", writes = targets.Select(GraphBinding.Texture).ToArray(),
    };

    private static GraphPass Kernel(int target)
    {
        GraphPass kernel = Writing(target);
        kernel.kind = PassKind.Compute;
        kernel.groups = GraphGroups.TexelsOf(target);
        return kernel;
    }

    private void Add(GraphExtent extent, int depth = 1, int layers = 1, int samples = 1, int mips = 1) =>
        textures.Add(new GraphTexture("t", extent, GraphicsFormat.R32_SFloat, width: 64, height: 64, depth: depth,
                                      mips: mips, layers: layers, samples: samples));

    [Test]
    public void ADeviceThatCanDoAllHasNoProblem()
    {
        Add(GraphExtent.Fixed, depth: 8);
        Add(GraphExtent.Tile, samples: 4);
        Assert.That(DeviceLimits.Problem(Chain(Writing(1), Writing(2))), Is.Null);
        Assert.That(DeviceLimits.StereoProblem(Chain(Writing(1), Writing(2))), Is.Null);
    }

    private static TestCaseData Limit(string problem, Action lacks, GraphExtent extent, int depth = 1, int layers = 1,
                                      int samples = 1) => new(problem, lacks, extent, depth, layers, samples);

    private static void LacksArrays() => SystemInfo.supports2DArrayTextures = false;

    private static readonly TestCaseData[] Limits =
    {
        Limit("this device cannot draw to 3D textures", () => SystemInfo.supports3DRenderTextures = false,
              GraphExtent.Fixed, depth: 8),
        Limit("this device does not support texture arrays", LacksArrays, GraphExtent.Fixed, layers: 2),
        Limit("this device does not support texture arrays", LacksArrays, GraphExtent.Tile),
        Limit("this device cannot read multisampled textures", () => SystemInfo.supportsMultisampledTextures = 0,
              GraphExtent.Screen, samples: 4),
    };

    [TestCaseSource(nameof(Limits))]
    public void ATextureThatTheDeviceLacksIsNamed(string problem, Action lacks, object extent, int depth, int layers,
                                                  int samples)
    {
        Add((GraphExtent)extent, depth, layers, samples);
        Assert.That(DeviceLimits.Problem(Chain(Writing(1))), Is.Null);
        lacks();
        Assert.That(DeviceLimits.Problem(Chain(Writing(1))), Is.EqualTo(problem));
    }

    [Test]
    public void CopiesOfLevels()
    {
        Add(GraphExtent.Map, mips: 0);
        GraphPass mips = Writing(1);
        mips.program = "Mips";
        mips.eachMip = true;
        mips.reads = new[] { GraphBinding.Texture("_Before", 1) };
        SystemInfo.copyTextureSupport = CopyTextureSupport.None;
        Assert.That(DeviceLimits.Problem(Chain(Writing(1), mips)),
                    Is.EqualTo("pass 'Mips' generates mip levels from copies, and this device cannot copy textures"));
        Assert.That(DeviceLimits.Problem(Chain(Writing(1))), Is.Null);
    }

    [Test]
    public void Targets()
    {
        Add(GraphExtent.Map);
        Add(GraphExtent.Map);
        SystemInfo.supportedRenderTargetCount = 1;
        Assert.That(DeviceLimits.Problem(Chain(Writing(1, 2))),
                    Is.EqualTo("pass 'Means' draws to 2 textures at once, and this device supports 1"));
        Assert.That(DeviceLimits.Problem(Chain(Writing(1), Writing(2))), Is.Null);
    }

    [Test]
    public void LayersOfBothEyesAtOnce()
    {
        Add(GraphExtent.Screen, layers: 3);
        Assert.That(DeviceLimits.StereoProblem(Chain(Writing(1))), Does.StartWith("a texture of the screen has layers"));
    }

    [Test]
    public void KernelsOverBothEyesAtOnce()
    {
        Add(GraphExtent.Map);
        Assert.That(StereoProblem(Chain(Kernel(1))), Is.Null, "over the map");
        Add(GraphExtent.Screen);
        GraphPass reading = Kernel(1);
        reading.reads = new[] { GraphBinding.Texture("_Screen", 2) };
        ShadowChain chain = Chain(Writing(2), reading);
        Assert.That(StereoProblem(chain), Does.StartWith("kernel 'Means' uses textures of the screen"));
        Assert.That(StereoProblem(chain, ChainKeywords.BothEyes), Is.Null);
    }

    private static string StereoProblem(ShadowChain chain, params string[] declared)
    {
        var asset = new ProgramAsset(new ComputeShader { KeywordNames = declared.ToList() }, null, ChainKeywords.All,
                                     chain.Keywords);
        return DeviceLimits.StereoProblem(chain) ??
               chain.Steps.Select(step => DeviceLimits.StereoProblem(chain, step, asset))
                   .FirstOrDefault(problem => problem != null);
    }

    /// <summary>Devices whose kernels do not write a channel of 8 bits write one of 32.</summary>
    [Test]
    public void AVisibilityOfKernelsHasAnotherFormat()
    {
        pass = Kernel(0);
        SystemInfo.Unsupported = GraphicsFormat.R8_UNorm;
        ShadowChain chain = Chain();
        Assert.That(DeviceLimits.Problem(chain), Is.Null);
        Assert.That(DeviceFormats.Of(chain.Slots[0]), Is.EqualTo(GraphicsFormat.R32_SFloat));
        SystemInfo.Unsupported = null;
        Assert.That(DeviceFormats.Of(chain.Slots[0]), Is.EqualTo(GraphicsFormat.R8_UNorm));
    }

    [Test]
    public void ALevelsCopyHasTheTexturesFormat()
    {
        SystemInfo.Unsupported = GraphicsFormat.R8_UNorm;
        var whole = new ChainTexture(new GraphTexture("t", GraphExtent.Map, GraphicsFormat.R8_UNorm, mips: 0), true,
                                     false);
        Assert.That(DeviceFormats.Of(whole.CopyOf(1)), Is.EqualTo(DeviceFormats.Of(whole)));
    }
}
