namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// Compiles tests/csharp/EditMode as Unity's test runner does: beside the package, in C# 9 and .NET Standard 2.1,
/// without what only our declarations have.
/// </summary>
public sealed class EditModeTests
{
    private static readonly string[] Folders = ["Runtime", "Editor", "tests/csharp/EditMode"];

    private static Findings Check(string root, string generation)
    {
        var set = SymbolSet.All.First(one => one.IsEditor);
        var unity = UnityVersion.Parse(generation);
        var declarations = new Declarations(Repository.At("tests/csharp/UnityApi"), generation, Repository.Root);
        var findings = new Findings();
        findings.Begin(set);
        new OwnUse(PackageSources.Read(root, Folders), PackageVersions.Of(unity), findings)
        {
            Frameworks = [MetadataReference.CreateFromFile(typeof(TestAttribute).Assembly.Location)],
            Symbols = ["UNITY_INCLUDE_TESTS"],
        }.Check(set, declarations.Compile(set, unity));
        return findings;
    }

    [TestCase("2022.3")]
    [TestCase("6000.0")]
    [TestCase("6000.5")]
    public void CompileInUnity(string generation) => Assert.That(Check(Repository.Root, generation).Problems, Is.Empty);

    // Each of these is a compilation of its own, because a later version's syntax ends one before types are looked up.
    private static readonly (string Code, string Expected)[] NotInUnity =
    [
        ("class A { object B => UnityEngine.Shader.Known; }", "ours, not Unity's"),
        ("class B { object C => typeof(Penumbra.Tests.FakeScene); }", "CS0234"),
        ("class C { object D => new System.Half(); }", "CS0234"),
    ];

    [Test]
    public void WhatUnityHasNotIsFound()
    {
        var problems = ProblemsWith(NotInUnity.Select(one => one.Code));
        for (var i = 0; i < NotInUnity.Length; ++i)
        {
            var ofFile = problems.Where(problem => problem.StartsWith($"{Folders[^1]}/Other{i}.cs:1:"));
            Assert.That(ofFile, Has.Some.Contains(NotInUnity[i].Expected), NotInUnity[i].Code);
        }
    }

    [Test]
    public void WhatItsCompilerLacksIsFound() =>
        Assert.That(ProblemsWith(["namespace A;"]), Has.Some.StartsWith(Folders[^1] + "/Other0.cs:1:").And.Some.Contains("CS8773"));

    private static IEnumerable<string> ProblemsWith(IEnumerable<string> files)
    {
        using var folder = new TemporaryFolder();
        foreach (var part in Folders) folder.Copy(Repository.At(part), part);
        foreach (var (code, i) in files.Select((code, i) => (code, i)))
            folder.Write($"{Folders[^1]}/Other{i}.cs", code + "\n");
        return Check(folder.Path, "6000.0").Problems;
    }
}
