namespace Penumbra.ApiCheck.Sources;

/// <summary>
/// The engine, core and URP as symbols: names, base types and constants are resolved by the compiler over the whole
/// text. Method bodies are not looked at, and packages that were not given leave types that are known by name only.
/// </summary>
public sealed class RealWorld(IReadOnlyList<RealSource> sources, PackageVersions versions)
{
    // The names under which the engine lets the pipelines see its internals, which name lookup needs.
    private static readonly Dictionary<string, string> AssemblyNames = new()
    {
        [SourceFolder.Engine] = "UnityEngine", [SourceFolder.Core] = "Unity.RenderPipelines.Core.Runtime",
        [SourceFolder.Universal] = "Unity.RenderPipelines.Universal.Runtime",
    };

    private readonly Dictionary<string, CSharpCompilation> shared = [];

    public IReadOnlyList<RealSource> Sources => sources;

    public IReadOnlyDictionary<string, CSharpCompilation> Under(SymbolSet set)
    {
        var compiled = new Dictionary<string, CSharpCompilation>();
        foreach (var source in sources)
        {
            var name = source.Folder.Source;
            if (!shared.TryGetValue(name, out var compilation))
            {
                var below = compiled.Values.Select(other => (MetadataReference)other.ToMetadataReference());
                compilation = CSharpCompilation.Create(AssemblyNames[name], source.Trees(set, versions),
                    below.Append(Profile.Reference),
                    new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true));
                if (name == SourceFolder.Engine && !source.IsConditional) shared[name] = compilation;
            }
            compiled[name] = compilation;
        }
        return compiled;
    }
}
