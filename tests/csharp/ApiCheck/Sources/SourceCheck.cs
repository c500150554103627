namespace Penumbra.ApiCheck.Sources;

/// <summary>The request of a check against real sources, whose folders are named by engine, core and universal.</summary>
public sealed record SourceRequest(string Generation, string Package, string Declarations,
                                   IReadOnlyDictionary<string, string> Folders);

/// <summary>
/// Checks every declaration of a generation against the C# of engine, core and URP, and the package against the
/// declarations, under each symbol set: `check-unity-api --engine`.
/// </summary>
public sealed class SourceCheck
{
    public Findings Findings { get; } = new();
    public IReadOnlyList<RealSource> Sources { get; private set; } = [];

    public static SourceCheck Run(SourceRequest request)
    {
        var check = new SourceCheck();
        SourceFolder[] folders = [.. SourceFolder.All.Where(request.Folders.ContainsKey)
            .Select(source => SourceFolder.Open(source, request.Folders[source]))];
        var declarations = new Declarations(request.Declarations, request.Generation, request.Package);
        check.Sources = [.. folders.Select(RealSource.Read)];

        var versions = Versions(request.Generation, folders);
        var real = new RealWorld(check.Sources, versions);
        var use = new OwnUse(PackageSources.Read(request.Package), versions, check.Findings);
        foreach (var set in SymbolSet.All)
        {
            check.Findings.Begin(set);
            var declared = declarations.Compile(set, versions.Unity);
            var parents = use.Check(set, declared);
            new ApiComparison(real.Under(set), set.IsEditor, parents, check.Findings).Compare(declared);
        }
        return check;
    }

    /// <summary>The versions that the sources say, and the generation's first release where they say nothing.</summary>
    private static PackageVersions Versions(string generation, IReadOnlyList<SourceFolder> folders)
    {
        var engine = folders.FirstOrDefault(folder => folder.Source == SourceFolder.Engine)?.Version;
        var unity = engine is null ? UnityVersion.Parse(generation) : UnityVersion.Parse(engine);
        if (unity.Generation != generation)
            throw CheckException.Usage($"the engine's source is of {unity.Text}: that is generation {unity.Generation}, not " +
                                       generation);
        var known = new Dictionary<string, string>();
        foreach (var folder in folders.Where(folder => folder.Source != SourceFolder.Engine))
            known[folder.Source == SourceFolder.Core ? PackageVersions.Core : PackageVersions.Universal] = folder.Version;
        return PackageVersions.Of(unity, known);
    }
}
