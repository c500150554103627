namespace Penumbra.Tests;

/// <summary>Assets that a pass needs are in the feature's asset, and thereby in players.</summary>
public sealed class PassAssetsTests
{
    private const string Reduction = "Shaders/Reduction.compute";
    private const string Path = "Packages/com.penumbra.shadows/" + Reduction;

    private static readonly TechniqueGraph[] Graphs =
    {
        TechniqueTable.Graph("pcss"),
        new TechniqueGraph { passes = new[] { new GraphPass { kind = PassKind.Compute, asset = Reduction } } },
    };

    [TearDown]
    public void TearDown() => AssetDatabase.Assets.Clear();

    [Test]
    public void TheEditorFindsItOnceAndThePlayerHasIt()
    {
        var kept = new PassAssets();
        Assert.That(kept.Find(Graphs), Is.False, "not imported yet");
        Assert.That(kept.Of(Reduction), Is.Null);

        var shader = new ComputeShader();
        AssetDatabase.Assets[Path] = shader;
        Assert.That(kept.Find(Graphs));
        Assert.That(kept.Find(Graphs), Is.False, "is there already");
        AssetDatabase.Assets.Clear();  // a player has none
        Assert.That(kept.Of(Reduction), Is.SameAs(shader));
    }

    /// <summary>A copy brings the .meta files along, and with them the GUIDs.</summary>
    [Test]
    public void APackageThatWasCopiedIntoAssetsIsFound()
    {
        string meta = System.IO.Path.Combine(FakeShader.PackageRoot(), "Shaders.meta");
        Assert.That(System.IO.File.ReadAllText(meta), Does.Contain("guid: " + PassAssets.FolderGuid));
        string installed = AssetDatabase.Guids[PassAssets.FolderGuid];
        AssetDatabase.Guids[PassAssets.FolderGuid] = "Assets/Third Party/Penumbra/Shaders";
        var shader = new ComputeShader();
        AssetDatabase.Assets["Assets/Third Party/Penumbra/" + Reduction] = shader;
        var kept = new PassAssets();
        bool found = kept.Find(Graphs);
        AssetDatabase.Guids.Remove(PassAssets.FolderGuid);
        bool withoutIt = new PassAssets().Find(Graphs);
        AssetDatabase.Guids[PassAssets.FolderGuid] = installed;
        Assert.That(found);
        Assert.That(kept.Of(Reduction), Is.SameAs(shader));
        Assert.That(withoutIt, Is.False);
    }

    [Test]
    public void AnAssetThatWentIsFoundAgain()
    {
        var kept = new PassAssets();
        var old = new ComputeShader();
        AssetDatabase.Assets[Path] = old;
        kept.Find(Graphs);
        old.Destroyed = true;
        var shader = new ComputeShader();
        AssetDatabase.Assets[Path] = shader;
        Assert.That(kept.Find(Graphs));
        Assert.That(kept.Of(Reduction), Is.SameAs(shader));
    }

    /// <summary>The feature has its own shader apart, by its name.</summary>
    [Test]
    public void TheFeaturesOwnShaderIsNotAmongThem()
    {
        AssetDatabase.Assets["Packages/com.penumbra.shadows/" + PenumbraShadows.ShaderFile] = new Shader();
        Assert.That(new PassAssets().Find(Graphs), Is.False);
    }
}
