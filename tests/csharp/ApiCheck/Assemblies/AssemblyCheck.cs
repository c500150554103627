namespace Penumbra.ApiCheck.Assemblies;

/// <summary>
/// Compiles the package's C# against real assemblies, for the editor and for a player, with the symbols that this Unity
/// defines: `check-unity-api DIR`. Each error stands at file, line and column.
/// </summary>
public sealed class AssemblyCheck
{
    private static readonly SymbolSet[] Sets = [SymbolSet.All[0], SymbolSet.All[1]];

    public List<string> Problems { get; } = [];
    public List<string> Notes { get; } = [];

    public static AssemblyCheck Run(string root, IReadOnlyList<string> folders, string? version)
    {
        if (version is not null) UnityVersion.Parse(version);
        var package = PackageSources.Read(root);
        var layout = UnityLayout.Find(folders);
        var index = new AssemblyIndex(layout);
        var missing = index.Missing(package).ToArray();
        if (missing.Length > 0)
            throw CheckException.Missing("assemblies are missing:\n  " + string.Join("\n  ", missing));
        // The render graph left its experimental namespace with pipeline 17.
        var unity = VersionSearch.Find(layout, version, () => UnityVersion.Parse(
            index.HasType("UnityEngine.Rendering.RenderGraphModule.RenderGraph") ? "6000.0" : "2022.3"));
        var check = new AssemblyCheck();
        check.Compile(package, PackageVersions.Of(unity.Version, VersionSearch.Packages(layout)), index);
        check.Describe(layout, unity);
        return check;
    }

    public string Json() =>
        JsonSerializer.Serialize(new { problems = Problems, notes = Notes }, Form).ReplaceLineEndings("\n") + "\n";

    private static readonly JsonSerializerOptions Form = new()
    {
        WriteIndented = true,
        Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    private void Compile(PackageSources package, PackageVersions versions, AssemblyIndex index)
    {
        var lines = new Dictionary<(Place? Place, string Text), List<string>>();
        var compiled = new SortedSet<string>(StringComparer.Ordinal);
        foreach (var set in Sets)
        {
            var build = new PackageBuild(package, versions, set);
            foreach (var compilation in build.Compile(assembly => index.For(assembly, set)))
            {
                compiled.Add(compilation.AssemblyName!);
                foreach (var diagnostic in compilation.GetDiagnostics().Where(IsTold))
                {
                    var word = diagnostic.Severity == DiagnosticSeverity.Error ? "error" : "warning";
                    var key = (Place.Of(diagnostic.Location), $"{word} {diagnostic.Id}: {diagnostic.GetMessage()}");
                    lines.TryAdd(key, []);
                    lines[key].Add(set.Name);
                }
            }
            Notes.AddRange(build.LeftOut);
        }
        foreach (var (line, sets) in lines.OrderBy(one => one.Key.Place?.File, StringComparer.Ordinal).ThenBy(one => one.Key.Place?.Line))
        {
            var place = line.Place is null ? "" : $"{line.Place}: ";
            var only = sets.Contains(Sets[0].Name) ? "" : " [player only]";
            (line.Text.StartsWith("error", StringComparison.Ordinal) ? Problems : Notes).Add(place + line.Text + only);
        }
        if (compiled.Count == 0) Problems.Add("no assembly of the package was compiled");
        Notes.Add($"{string.Join(", ", compiled)}: {Problems.Count} errors");
    }

    /// <summary>Whether a diagnostic is told: errors, and what this Unity calls obsolete.</summary>
    private static bool IsTold(Diagnostic diagnostic) =>
        diagnostic.Severity == DiagnosticSeverity.Error || diagnostic.Id is "CS0618" or "CS0612";

    private void Describe(UnityLayout layout, VersionSearch unity)
    {
        Notes.Add($"Unity {unity.Version.Text} by {unity.From}, engine in {layout.Engine}");
        Notes.Add(layout.Player is null
            ? "players: the editor's modules, as no build support is installed beside them"
            : $"players: {layout.Player}");
        Notes.Add(layout.Library.Count == 0
            ? "class library: .NET Standard 2.1 of this program, as the folders hold none"
            : $"class library: {layout.Library[0]}");
    }
}
