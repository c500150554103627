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
        if (folders.FirstOrDefault(folder => !Directory.Exists(folder)) is { } nowhere)
            throw CheckException.Usage($"{nowhere}: there is no such folder");
        var said = folders.Select(folder => Path.Combine(folder, "ProjectSettings", "ProjectVersion.txt")).FirstOrDefault(File.Exists);
        var unity = UnityVersion.Parse(version ?? (said is not null ? File.ReadAllText(said) : throw CheckException.Usage(
            "no folder is that of a project, which says the version of Unity: --version V says it")));
        if (unity.IsOlderThan(UnityVersion.Oldest))
            throw CheckException.Usage($"Unity {unity.Text} is older than 2022.3, which the package needs");
        var package = PackageSources.Read(root);
        var found = new FoundAssemblies(folders);
        var missing = found.Missing(package).ToArray();
        if (missing.Length > 0)
            throw CheckException.Missing("assemblies are missing:\n  " + string.Join("\n  ", missing));
        var check = new AssemblyCheck();
        check.Compile(package, PackageVersions.Of(unity), found);
        check.Notes.Add($"Unity {unity.Text}, engine in {found.Engine}");
        check.Notes.Add("players: " + (found.Player ?? "the editor's modules, as no build support is installed beside them"));
        return check;
    }

    public string Json() =>
        JsonSerializer.Serialize(new { problems = Problems, notes = Notes }, Form).ReplaceLineEndings("\n") + "\n";

    private static readonly JsonSerializerOptions Form = new()
    {
        WriteIndented = true,
        Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    private void Compile(PackageSources package, PackageVersions versions, FoundAssemblies found)
    {
        var lines = new Dictionary<(Place? Place, string Text), List<string>>();
        var compiled = new SortedSet<string>(StringComparer.Ordinal);
        foreach (var set in Sets)
        {
            var build = new PackageBuild(package, versions, set);
            foreach (var compilation in build.Compile(assembly => found.For(assembly, set)))
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
}
