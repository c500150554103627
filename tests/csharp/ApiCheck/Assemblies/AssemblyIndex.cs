namespace Penumbra.ApiCheck.Assemblies;

/// <summary>The assemblies of a layout by name, and what a package's assembly is given of them.</summary>
public sealed class AssemblyIndex
{
    private readonly Dictionary<string, ManagedFile> scripts = [];
    private readonly IReadOnlyList<ManagedFile> engine;
    private readonly IReadOnlyList<ManagedFile> player;
    private readonly IReadOnlyList<MetadataReference> library;
    private readonly UnityLayout layout;

    public AssemblyIndex(UnityLayout layout)
    {
        this.layout = layout;
        engine = layout.Engine is null ? [] : [.. ManagedFile.In(layout.Engine).Where(IsEngine)];
        player = layout.Player is null ? engine : [.. ManagedFile.In(layout.Player).Where(IsEngine)];
        foreach (var file in layout.Scripts.SelectMany(ManagedFile.In).Where(file => !IsEngine(file)))
            scripts.TryAdd(file.Name, file);
        library = layout.Library.Count == 0
            ? [Profile.Reference]
            : [.. layout.Library.SelectMany(ManagedFile.In).DistinctBy(file => file.Name)
                .Where(file => layout.IsInstallation || IsLibraryName(file.Name)).Select(Reference)];
    }

    /// <summary>Messages, one line for each assembly that is needed and not there, with the way out.</summary>
    public IEnumerable<string> Missing(PackageSources package)
    {
        var needsEditor = package.Assemblies.Any(assembly => assembly.IsEditorOnly);
        string[] modules = needsEditor ? ["UnityEngine.CoreModule", "UnityEditor.CoreModule"] : ["UnityEngine.CoreModule"];
        foreach (var name in modules.Where(name => engine.All(file => file.Name != name)))
            yield return $"{name}.dll: {Fault(layout.Engine, name)}; it lies in Managed/UnityEngine of a Unity installation " +
                         "(Editor/Data, on macOS Unity.app/Contents): name the installation's folder too";
        var own = package.Assemblies.Select(assembly => assembly.Name).ToHashSet();
        var outside = package.Assemblies.SelectMany(assembly => assembly.References.Select(name => (assembly, name)))
            .Where(entry => !own.Contains(entry.name) && !scripts.ContainsKey(entry.name)).DistinctBy(entry => entry.name);
        foreach (var (assembly, name) in outside)
        {
            yield return name.StartsWith("GUID:", StringComparison.Ordinal)
                ? $"{name} ({assembly.Name}): a reference by GUID cannot be followed here: refer to the assembly by its name"
                : $"{name}.dll, to which {assembly.Name} refers: {Fault(layout.Scripts.FirstOrDefault(), name)}; Unity compiles it " +
                  "into Library/ScriptAssemblies of a project that has the package: open one and name its folder too";
        }
    }

    /// <summary>Whether some assembly of a package has a type of this full name.</summary>
    public bool HasType(string name)
    {
        var compilation = CSharpCompilation.Create("search", references: scripts.Values.Select(Reference));
        return compilation.GetTypeByMetadataName(name) is not null;
    }

    /// <summary>
    /// The assemblies that a package's assembly refers to: the class library, the engine's modules and those that the
    /// asmdef names. Assemblies that those refer to in turn are not passed on, as Unity does not either.
    /// </summary>
    public IEnumerable<MetadataReference> For(Asmdef assembly, SymbolSet set)
    {
        var modules = set.IsEditor ? engine : player.Where(file => !IsNamed(file, "UnityEditor"));
        var named = assembly.References.Where(scripts.ContainsKey).Select(name => scripts[name]);
        return library.Concat(modules.Concat(named).Select(Reference));
    }

    private static MetadataReference Reference(ManagedFile file) => MetadataReference.CreateFromFile(file.File);

    private static string Fault(string? folder, string name) =>
        folder is not null && File.Exists(Path.Combine(folder, name + ".dll"))
            ? $"the file in {folder} is not a .NET assembly"
            : "missing";

    private static bool IsEngine(ManagedFile file) => IsNamed(file, "UnityEngine") || IsNamed(file, "UnityEditor");

    /// <summary>Whether the file is the assembly of that name, or a module of it.</summary>
    private static bool IsNamed(ManagedFile file, string name) =>
        file.Name == name || file.Name.StartsWith(name + ".", StringComparison.Ordinal);

    private static bool IsLibraryName(string name) => name is "netstandard" or "mscorlib" or "System" ||
        name.StartsWith("System.", StringComparison.Ordinal) || name.StartsWith("Microsoft.Win32.", StringComparison.Ordinal);
}
