using System.Collections.Immutable;

namespace Penumbra.ApiCheck.Package;

/// <summary>
/// Compiles the package's assemblies in memory under one symbol set. The caller says what an assembly of the outside
/// is; the package's own ones refer to each other.
/// </summary>
public sealed class PackageBuild(PackageSources sources, PackageVersions versions, SymbolSet set)
{
    /// <summary>Symbols beside those of the symbol set and of versionDefines.</summary>
    public IReadOnlyList<string> Symbols { get; init; } = [];

    /// <summary>Assemblies whose constraints or platforms leave them out, with the reason.</summary>
    public List<string> LeftOut { get; } = [];

    public List<CSharpCompilation> Compile(Func<Asmdef, IEnumerable<MetadataReference>> outside)
    {
        var compiled = new Dictionary<string, CSharpCompilation>();
        foreach (var assembly in sources.Assemblies)
        {
            var symbols = set.Symbols(versions.Unity).Concat(versions.Symbols(assembly, set)).Concat(Symbols).ToHashSet();
            if (Reason(assembly, symbols) is { } reason)
            {
                if (reason.Length > 0) LeftOut.Add(reason);
                continue;
            }
            var own = assembly.References.Where(compiled.ContainsKey)
                .Select(name => (MetadataReference)compiled[name].ToMetadataReference());
            compiled[assembly.Name] = CSharpCompilation.Create(assembly.Name, sources.Trees(assembly, symbols),
                outside(assembly).Concat(own), Options(assembly));
        }
        return [.. compiled.Values];
    }

    /// <summary>Errors and, apart from them, uses of what Unity has marked obsolete.</summary>
    public static ImmutableArray<Diagnostic> Errors(Compilation compilation) =>
        [.. compilation.GetDiagnostics().Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error)];

    private static CSharpCompilationOptions Options(Asmdef assembly) =>
        new(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: assembly.AllowsUnsafeCode, concurrentBuild: true,
            assemblyIdentityComparer: DesktopAssemblyIdentityComparer.Default);

    /// <summary>
    /// The reason why the assembly is not compiled: null where it is compiled, empty where an editor's assembly has no
    /// place in a player.
    /// </summary>
    private string? Reason(Asmdef assembly, IReadOnlySet<string> symbols)
    {
        if (assembly.IsEditorOnly && !set.IsEditor) return "";
        if (set.IsEditor && assembly.ExcludePlatforms.Contains("Editor"))
            return $"{assembly.Name} is not compiled for the editor: excludePlatforms";
        return assembly.UnmetConstraint(symbols) is { } constraint
            ? $"{assembly.Name} is not compiled for the {set.Name}: its constraint {constraint} is not met"
            : null;
    }
}
