namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// The committed answers of the check against Unity's sources, which are not in the repository: they are of the
/// present declarations, and nothing differed.
/// </summary>
public sealed class ResultsTests
{
    private static SourceReport Committed(string generation) =>
        SourceReport.Read(Repository.At($"Documentation~/results/api-check-{generation}.json"));

    [TestCase("2022.3")]
    [TestCase("6000.0")]
    [TestCase("6000.5")]
    public void AreOfThePresentDeclarations(string generation)
    {
        var committed = Committed(generation).Types.ToDictionary(type => type.Name, type => type.Fingerprint);
        var present = Fingerprints(generation);
        var changed = committed.Keys.Union(present.Keys)
            .Where(name => committed.GetValueOrDefault(name) != present.GetValueOrDefault(name)).Order(StringComparer.Ordinal);
        Assert.That(changed, Is.Empty, "declarations changed since they were compared with Unity's sources: run scripts/check-unity-api " +
            $"--engine DIR --core DIR --universal DIR --generation {generation} " +
            $"--output Documentation~/results/api-check-{generation}.json, then scripts/pages");
    }

    [TestCase("2022.3")]
    [TestCase("6000.0")]
    [TestCase("6000.5")]
    public void AreWithoutDifferences(string generation)
    {
        var report = Committed(generation);
        Assert.That(report.Problems, Is.Empty);
        Assert.That(report.Counts.Differences, Is.Zero);
        Assert.That(report.Types, Is.Not.Empty);
        Assert.That(report.Sources.Select(source => source.Source), Is.EqualTo(SourceFolder.All));
    }

    private static Dictionary<string, string> Fingerprints(string generation)
    {
        var declarations = new Declarations(Repository.At("tests/csharp/UnityApi"), generation, Repository.Root);
        var members = new Dictionary<string, List<string>>();
        foreach (var set in SymbolSet.All)
        {
            foreach (var type in Declarations.Types(declarations.Compile(set, UnityVersion.Parse(generation))).Where(Access.IsReachable))
            {
                members.TryAdd(Names.Of(type), []);
                members[Names.Of(type)].AddRange(Signature.AllOf(type));
            }
        }
        return members.ToDictionary(entry => entry.Key, entry => SourceReport.Fingerprint(entry.Value));
    }
}
