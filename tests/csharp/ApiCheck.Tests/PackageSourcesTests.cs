namespace Penumbra.ApiCheck.Tests;

/// <summary>The assembly that each file belongs to, and the code that is compiled for editor and player.</summary>
public sealed class PackageSourcesTests
{
    private TemporaryFolder folder = null!;

    [SetUp]
    public void SetUp()
    {
        folder = new TemporaryFolder();
        folder.Write("Runtime/A.asmdef", """{ "name": "A" }""");
        folder.Write("Runtime/One.cs", "");
        folder.Write("Runtime/Inner/B.asmdef", """{ "name": "B", "defineConstraints": [ "UNITY_6000_0_OR_NEWER" ], "references": [ "A" ] }""");
        folder.Write("Runtime/Inner/Two.cs", "");
        folder.Write("Runtime/Hidden~/Three.cs", "not C#");
        folder.Write("Editor/E.asmdef", """{ "name": "E", "includePlatforms": [ "Editor" ], "references": [ "A", "B" ] }""");
        folder.Write("Editor/Four.cs", "");
    }

    [TearDown]
    public void TearDown() => folder.Dispose();

    private string Refusal() => Assert.Throws<CheckException>(() => PackageSources.Read(folder.Path))!.Message;

    [Test]
    public void FilesBelongToTheNearestAsmdef()
    {
        var sources = PackageSources.Read(folder.Path);
        Assert.That(sources.Assemblies.Select(assembly => $"{assembly.Name}: {string.Join(" ", sources.Trees(assembly, []).Select(tree => tree.FilePath))}"),
                    Is.EqualTo(new[] { "A: Runtime/One.cs", "B: Runtime/Inner/Two.cs", "E: Editor/Four.cs" }));
    }

    [TestCase("2022.3", "editor", "A E", "B is not compiled for the editor: its constraint UNITY_6000_0_OR_NEWER is not met")]
    [TestCase("2022.3", "player", "A", "B is not compiled for the player: its constraint UNITY_6000_0_OR_NEWER is not met")]
    [TestCase("6000.0", "editor", "A B E", "")]
    [TestCase("6000.0", "player", "A B", "")]
    [TestCase("6000.5", "player", "A B", "")]
    public void ConstraintsAndPlatformsAreRespected(string version, string set, string compiled, string leftOut)
    {
        var build = new PackageBuild(PackageSources.Read(folder.Path), PackageVersions.Of(UnityVersion.Parse(version)),
                                     SymbolSet.All.Single(one => one.Name == set));
        Assert.That(string.Join(" ", build.Compile(_ => [Profile.Reference]).Select(compilation => compilation.AssemblyName)), Is.EqualTo(compiled));
        Assert.That(string.Join(" ", build.LeftOut), Is.EqualTo(leftOut));
    }

    [Test]
    public void ALinkThatLeadsBackIsNotFollowed()
    {
        Directory.CreateSymbolicLink(folder.At("Runtime/Inner/Back"), folder.At("Runtime"));
        Assert.That(ShippedFiles.Below(folder.At("Runtime")).Count(), Is.EqualTo(4));
    }

    [Test]
    public void AFileWithoutAssemblyIsRefused()
    {
        File.Delete(folder.At("Editor/E.asmdef"));
        Assert.That(Refusal(), Is.EqualTo($"{folder.At("Editor/Four.cs")}:1:1: no .asmdef in its folder or above: Unity does not compile this file in a package"));
    }

    [Test]
    public void AssembliesThatReferInACircleAreRefused()
    {
        folder.Write("Runtime/A.asmdef", """{ "name": "A", "references": [ "B" ] }""");
        Assert.That(Refusal(), Does.EndWith(" refers to itself through its references"));
    }

    [Test]
    public void ANameTwiceIsRefused()
    {
        folder.Write("Editor/E.asmdef", """{ "name": "A" }""");
        Assert.That(Refusal(), Is.EqualTo($"{folder.At("Editor/E.asmdef")}:1:1: the assembly A is defined twice, also in {folder.At("Runtime/A.asmdef")}"));
    }

    [Test]
    public void AFolderWithoutPackageIsRefused() => Assert.That(
        Assert.Throws<CheckException>(() => PackageSources.Read(folder.At("Runtime")))!.Message,
        Is.EqualTo($"{folder.At("Runtime")} holds no package: there is no .asmdef in Runtime/ or Editor/"));
}
