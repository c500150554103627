namespace Penumbra.ApiCheck.Assemblies;

/// <summary>
/// The assemblies below the folders that the command names, known by their files' names: whatever the layout of an
/// installation (Windows, Linux, macOS), of a project or of a folder of assemblies.
/// </summary>
public sealed class FoundAssemblies
{
    private const string CoreModule = "UnityEngine.CoreModule.dll";

    private readonly ILookup<string, string> files;

    public FoundAssemblies(IEnumerable<string> folders)
    {
        var search = new EnumerationOptions { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint };
        // A project has its packages' assemblies in Library/ScriptAssemblies, and other copies in Library/Bee.
        files = folders.SelectMany(folder => Directory.EnumerateFiles(Path.GetFullPath(folder), "Unity*.dll", search))
            .OrderBy(file => Path.GetFileName(Path.GetDirectoryName(file)) != "ScriptAssemblies").ThenBy(file => file, StringComparer.Ordinal)
            .ToLookup(file => Path.GetFileName(file)!);
        Engine = FolderOfModules(IsOfPlayer: false);
        Player = FolderOfModules(IsOfPlayer: true);
    }

    /// <summary>The folder of the engine's modules as the editor has them.</summary>
    public string? Engine { get; }

    /// <summary>The folder of the engine's modules as players have them, where build support is installed.</summary>
    public string? Player { get; }

    /// <summary>Messages, one line for each assembly that is needed and not there, with the way out.</summary>
    public IEnumerable<string> Missing(PackageSources package)
    {
        if (Engine is null)
            yield return $"{CoreModule}: it lies in Managed/UnityEngine of a Unity installation: name the installation's folder too";
        var own = package.Assemblies.Select(assembly => assembly.Name).ToHashSet();
        var outside = package.Assemblies.SelectMany(assembly => assembly.References.Select(name => (assembly, name)))
            .Where(entry => !own.Contains(entry.name) && !files.Contains(entry.name + ".dll")).DistinctBy(entry => entry.name);
        foreach (var (assembly, name) in outside)
            yield return $"{name}.dll, to which {assembly.Name} refers: Unity compiles it into Library/ScriptAssemblies of a project " +
                         "that has the package: open one and name its folder too";
    }

    /// <summary>
    /// The assemblies that a package's assembly refers to: the class library, the engine's modules and those that the
    /// asmdef names. Assemblies that those refer to in turn are not passed on, as Unity does not either.
    /// </summary>
    public IEnumerable<MetadataReference> For(Asmdef assembly, SymbolSet set)
    {
        var modules = Directory.EnumerateFiles(set.IsEditor ? Engine! : Player ?? Engine!, "Unity*.dll").Where(file =>
            Path.GetFileName(file) is var name && (name.StartsWith("UnityEngine.") || (set.IsEditor && name.StartsWith("UnityEditor."))));
        return modules.Concat(assembly.References.SelectMany(name => files[name + ".dll"].Take(1)))
            .Select(file => (MetadataReference)MetadataReference.CreateFromFile(file)).Prepend(Profile.Reference);
    }

    private string? FolderOfModules(bool IsOfPlayer) => files[CoreModule]
        .Where(file => file.Split(Path.DirectorySeparatorChar).Contains("PlaybackEngines") == IsOfPlayer)
        .Select(Path.GetDirectoryName).FirstOrDefault();
}
