namespace Penumbra.ApiCheck.Tests;

/// <summary>Folders of sources: what is recognised, which version it says it has, and what is refused.</summary>
public sealed class SourceSearchTests
{
    private const string Reference = "## Unity 6000.0.23f1 C# reference source code";

    private TemporaryFolder folder = null!;

    [SetUp]
    public void SetUp() => folder = new TemporaryFolder();

    [TearDown]
    public void TearDown() => folder.Dispose();

    private IReadOnlyList<SourceFolder> Find(params string[] folders) =>
        SourceSearch.Find(folders.Select(folder.At), new Dictionary<string, string>(), new Dictionary<string, string>());

    private void Engine(string at)
    {
        folder.Write($"{at}/README.md", Reference);
        folder.Write($"{at}/Runtime/Export/A.cs", "");
        folder.Write($"{at}/Editor/Mono/A.cs", "");
    }

    private void Pipeline(string at, string name, string version) =>
        folder.Write($"{at}/package.json", $$"""{ "name": "com.unity.render-pipelines.{{name}}", "version": "{{version}}" }""");

    private static string Refusal(Action action) => Assert.Throws<CheckException>(() => action())!.Message;

    [Test]
    public void ACheckoutAndAPackageCacheAreSearched()
    {
        Engine("UnityCsReference");
        Pipeline("Library/PackageCache/com.unity.render-pipelines.core@17.0.4", "core", "17.0.4");
        Pipeline("Library/PackageCache/com.unity.render-pipelines.universal@17.0.3", "universal", "17.0.3");
        Assert.That(Find("UnityCsReference", "Library").Select(found => (found.Source, found.Version, found.VersionFrom)), Is.EqualTo(new[]
        {
            ("engine", "6000.0.23f1", "README.md"), ("core", "17.0.4", "package.json"), ("universal", "17.0.3", "package.json"),
        }));
    }

    [Test]
    public void APackageWithoutManifestIsKnownByItsAssembly()
    {
        folder.Write("urp/Runtime/Unity.RenderPipelines.Universal.Runtime.asmdef", "{}");
        Assert.That(Find("urp").Single(), Is.EqualTo(new SourceFolder("universal", folder.At("urp"), null, "unknown")));
    }

    [Test]
    public void AVersionCanBeGivenWhereNoneIsSaid()
    {
        folder.Write("urp/Runtime/Unity.RenderPipelines.Universal.Runtime.asmdef", "{}");
        var versions = new Dictionary<string, string> { ["universal"] = "14.0.9" };
        var found = SourceSearch.Find([folder.At("urp")], new Dictionary<string, string>(), versions);
        Assert.That(found.Single(), Is.EqualTo(new SourceFolder("universal", folder.At("urp"), "14.0.9", "given")));
    }

    [Test]
    public void AVersionThatTheFolderContradictsIsRefused()
    {
        Pipeline("core", "core", "17.0.4");
        var versions = new Dictionary<string, string> { ["core"] = "17.0.3" };
        Assert.That(Refusal(() => SourceSearch.Find([folder.At("core")], new Dictionary<string, string>(), versions)),
                    Is.EqualTo($"{folder.At("core")} says in package.json that it is 17.0.4, the command says 17.0.3"));
    }

    [Test]
    public void TwoFoldersOfOneSourceAreRefused()
    {
        Pipeline("a/core", "core", "17.0.4");
        Pipeline("b/core", "core", "17.0.3");
        Assert.That(Refusal(() => Find("a", "b")), Is.EqualTo(
            $"two folders hold the source of core, {folder.At("a/core")} and {folder.At("b/core")}: name one with --core"));
        var named = new Dictionary<string, string> { ["core"] = folder.At("b/core") };
        Assert.That(SourceSearch.Find([folder.At("a"), folder.At("b")], named, new Dictionary<string, string>()).Single().Version, Is.EqualTo("17.0.3"));
    }

    [Test]
    public void AFolderWithoutSourcesIsRefused()
    {
        folder.Write("empty/a/b/c/package.json", """{ "name": "com.unity.render-pipelines.core" }""");
        Assert.That(Refusal(() => Find("empty")), Is.EqualTo(
            $"{folder.At("empty")}: neither Unity's C# reference (Runtime/Export, Editor/Mono) nor the package of core or URP is here or two " +
            "folders down: name them with --engine, --core and --universal"));
        Assert.That(Refusal(() => Find("nowhere")), Is.EqualTo($"{folder.At("nowhere")}: there is no such folder"));
    }

    [Test]
    public void ABrokenManifestIsToldWithItsPlace()
    {
        folder.Write("core/package.json", "{\n  \"name\": oops\n}");
        Assert.That(Refusal(() => Find("core")), Does.StartWith($"{folder.At("core/package.json")}:2:11: no JSON: "));
    }

    [TestCase("Editor/Mono/A.cs", true)]
    [TestCase("Modules/UIElementsEditor/A.cs", true)]
    [TestCase("Modules/UIElements/Editor/A.cs", true)]
    [TestCase("Modules/UIElements/A.cs", false)]
    [TestCase("Runtime/Export/Editor.cs", false)]
    [TestCase("Runtime/2D/Rendergraph/A.cs", false)]
    public void FilesOfTheEditorAreKnownByTheirFolder(string file, bool isEditors) =>
        Assert.That(SourceFolder.IsEditorFile(file), Is.EqualTo(isEditors));
}
