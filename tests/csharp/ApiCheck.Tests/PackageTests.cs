namespace Penumbra.ApiCheck.Tests;

/// <summary>Versions, version ranges, symbols and assembly definitions, against Unity's manual.</summary>
public sealed class PackageTests
{
    [TestCase("2022.3.17f1", 2022, 3, 17)]
    [TestCase("m_EditorVersion: 6000.0.23f1", 6000, 0, 23)]
    [TestCase("2023.2", 2023, 2, 0)]
    [TestCase("6000.1.0b12", 6000, 1, 0)]
    public void AVersionIsFound(string text, int major, int minor, int patch)
    {
        var version = UnityVersion.Find(text)!;
        Assert.That((version.Major, version.Minor, version.Patch), Is.EqualTo((major, minor, patch)));
    }

    [TestCase("4fc78088f837")]
    [TestCase("10.13.0")]
    [TestCase("Unity")]
    public void NoVersionIsFound(string text) => Assert.That(UnityVersion.Find(text), Is.Null);

    [Test]
    public void SymbolsGoUpToTheVersion()
    {
        var symbols = UnityVersion.Parse("2022.3.17f1").Symbols().ToArray();
        Assert.That(symbols, Has.Member("UNITY_2022_3_17").And.Member("UNITY_5_3_OR_NEWER").And.Member("UNITY_2021_3_OR_NEWER")
            .And.Member("UNITY_2022_3_OR_NEWER"));
        Assert.That(symbols, Has.No.Member("UNITY_2023_1_OR_NEWER").And.No.Member("UNITY_6000_0_OR_NEWER"));
        Assert.That(UnityVersion.Parse("6000.1.2f1").Symbols(), Has.Member("UNITY_2023_3_OR_NEWER").And.Member("UNITY_6000_0_OR_NEWER")
            .And.Member("UNITY_6000_1_OR_NEWER").And.No.Member("UNITY_6000_2_OR_NEWER"));
    }

    [TestCase("2022.3.17f1", "2022.3")]
    [TestCase("2023.1.0f1", "2022.3")]
    [TestCase("6000.0.0f1", "6000.0")]
    [TestCase("6000.3.1f1", "6000.0")]
    [TestCase("6000.5.2f1", "6000.5")]
    [TestCase("6000.7.0a1", "6000.5")]
    public void AVersionHasAGeneration(string version, string generation) =>
        Assert.That(UnityVersion.Parse(version).Generation, Is.EqualTo(generation));

    [TestCase("", "0.0.1", true)]
    [TestCase("14.0.0", "14.0.0", true)]
    [TestCase("14.0.0", "17.0.3", true)]
    [TestCase("14.0.1", "14.0.0", false)]
    [TestCase("[14.0,17.0)", "16.9.9", true)]
    [TestCase("[14.0,17.0)", "17.0.0", false)]
    [TestCase("(14.0,17.0]", "14.0.0", false)]
    [TestCase("(14.0,17.0]", "17.0.0", true)]
    [TestCase("[14.0]", "14.0.0", true)]
    [TestCase("[14.0]", "14.0.1", false)]
    [TestCase("[17.0,)", "18.0.0", true)]
    [TestCase("(,17.0)", "16.0.0", true)]
    [TestCase("17.0.0", "17.0.0-pre.1", false)]
    [TestCase("[17.0,17.4)", "17.4.0-pre.1", true)]
    [TestCase("2022.3.10f1", "2022.3.17f1", true)]
    [TestCase("1.0", "file:../package", false)]
    public void ARangeHoldsVersions(string expression, string version, bool holds) =>
        Assert.That(VersionRange.Parse(expression)!.Holds(version), Is.EqualTo(holds));

    [TestCase("[14.0")]
    [TestCase("latest")]
    [TestCase("[1,2,3]")]
    [TestCase("(a,b)")]
    public void ARangeCanBeNone(string expression) => Assert.That(VersionRange.Parse(expression), Is.Null);

    [TestCase("2022.3.17f1", "14.0.0")]
    [TestCase("2023.2.0f1", "16.0.0")]
    [TestCase("6000.0.23f1", "17.0.0")]
    [TestCase("6000.3.0f1", "17.3.0")]
    public void AUnityComesWithAPipeline(string unity, string pipeline) =>
        Assert.That(PackageVersions.Of(UnityVersion.Parse(unity)).Packages[PackageVersions.Universal], Is.EqualTo(pipeline));

    [Test]
    public void VersionDefinesFollowTheProject()
    {
        using var folder = new TemporaryFolder();
        var asmdef = Asmdef.Read(folder.Write("A.asmdef", """
            {
                "name": "A",
                "versionDefines": [
                    { "name": "com.unity.render-pipelines.universal", "expression": "[17.0,17.4)", "define": "MODE" },
                    { "name": "com.unity.modules.xr", "expression": "1.0.0", "define": "XR" },
                    { "name": "com.unity.inputsystem", "expression": "", "define": "INPUT" },
                    { "name": "Unity", "expression": "6000.0", "define": "SIX" }
                ]
            }
            """));
        var versions = PackageVersions.Of(UnityVersion.Parse("6000.0.23f1"), new Dictionary<string, string> { [PackageVersions.Universal] = "17.0.3" });
        Assert.That(versions.Symbols(asmdef, SymbolSet.All[0]), Is.EqualTo(new[] { "MODE", "XR", "SIX" }));
        Assert.That(versions.Symbols(asmdef, SymbolSet.All[2]), Is.EqualTo(new[] { "MODE", "SIX" }));
    }

    [TestCase("A", "A", true)]
    [TestCase("!A", "A", false)]
    [TestCase("!B", "A", true)]
    [TestCase("B || A", "A", true)]
    [TestCase("B || C", "A", false)]
    public void ConstraintsDecide(string constraint, string symbol, bool met)
    {
        var asmdef = new Asmdef("A.asmdef", "A") { DefineConstraints = [constraint] };
        Assert.That(asmdef.UnmetConstraint(new HashSet<string> { symbol }), Is.EqualTo(met ? null : constraint));
    }

    [TestCase("{\n  \"name\": ]\n}", ":2:11: no JSON: ")]
    [TestCase("{}", ":1:1: the assembly has no name: add \"name\"")]
    [TestCase("{ \"name\": 1 }", ":1:1: a field is missing or has the wrong type: ")]
    [TestCase("[]", ":1:1: a field is missing or has the wrong type: ")]
    [TestCase("{ \"name\": \"A\", \"versionDefines\": [ { \"expression\": \"new\" } ] }",
              ":1:1: 'new' is not a version expression such as 14.0.0 or [14.0,17.0)")]
    public void ABrokenAsmdefIsToldWithItsPlace(string text, string message)
    {
        using var folder = new TemporaryFolder();
        var file = folder.Write("A.asmdef", text);
        Assert.That(Assert.Throws<CheckException>(() => Asmdef.Read(file))!.Message, Does.StartWith(file + message));
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
