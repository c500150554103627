namespace Penumbra.ApiCheck.Assemblies;

/// <summary>
/// Finds where the assemblies lie in the folders that the command names. It understands an installation (Windows and
/// Linux Editor/Data, macOS Unity.app/Contents, with the modules in Managed/UnityEngine), a project
/// (Library/ScriptAssemblies) and a folder that holds the assemblies themselves. Several folders add up; the first that
/// has something wins.
/// </summary>
public sealed class UnityLayout
{
    private const string CoreModule = "UnityEngine.CoreModule.dll";

    private static readonly string[] DataFolders =
    [
        "", "Data", "Editor/Data", "Contents", "Contents/Resources/Scripting", "Unity.app/Contents",
        "Unity.app/Contents/Resources/Scripting", "Editor/Unity.app/Contents", "Editor/Unity.app/Contents/Resources/Scripting",
    ];

    private static readonly string[] ScriptFolders = ["Library/ScriptAssemblies", "ScriptAssemblies", ""];

    // The folders lead from the profile that a package's assemblies are compiled with to what an old project may have.
    private static readonly string[][] Libraries =
    [
        ["NetStandard/ref/2.1.0", "NetStandard/compat/2.1.0/shims/netfx", "NetStandard/compat/2.1.0/shims/netstandard"],
        ["UnityReferenceAssemblies/unity-4.8-api", "UnityReferenceAssemblies/unity-4.8-api/Facades"],
        ["MonoBleedingEdge/lib/mono/4.7.1-api", "MonoBleedingEdge/lib/mono/4.7.1-api/Facades"],
    ];

    /// <summary>The engine's modules as the editor has them.</summary>
    public string? Engine { get; private init; }

    /// <summary>
    /// The engine's modules as players have them; an installation has them where build support is installed.
    /// </summary>
    public string? Player { get; private init; }

    /// <summary>Folders with the assemblies of packages.</summary>
    public IReadOnlyList<string> Scripts { get; private init; } = [];

    /// <summary>Folders of the class library; without any, the one beside this program serves.</summary>
    public IReadOnlyList<string> Library { get; private init; } = [];

    /// <summary>
    /// Whether the folder is an installation, which keeps the class library apart; elsewhere it lies among other
    /// assemblies.
    /// </summary>
    public bool IsInstallation { get; private init; }

    public IReadOnlyList<string> Given { get; private init; } = [];

    public static UnityLayout Find(IReadOnlyList<string> given)
    {
        foreach (var folder in given.Where(folder => !Directory.Exists(folder)))
            throw CheckException.Usage($"{folder}: there is no such folder");
        var folders = given.Select(folder => Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder))).ToArray();
        var data = folders.SelectMany(folder => DataFolders.Select(inner => Path.Combine(folder, inner)))
            .FirstOrDefault(folder => File.Exists(Path.Combine(folder, "Managed", "UnityEngine", CoreModule)));
        var flat = folders.Concat(folders.Select(folder => Path.Combine(folder, "UnityEngine")))
            .FirstOrDefault(folder => File.Exists(Path.Combine(folder, CoreModule)));
        return new UnityLayout
        {
            Given = folders,
            IsInstallation = data is not null,
            Engine = data is null ? flat : Path.Combine(data, "Managed", "UnityEngine"),
            Player = data is null ? null : PlayerModules(data),
            Scripts = [.. folders.SelectMany(folder => ScriptFolders.Select(inner => Path.Combine(folder, inner)))
                .Where(folder => Directory.Exists(folder) && Directory.EnumerateFiles(folder, "*.dll").Any())],
            Library = data is null ? FlatLibrary(folders) : InstalledLibrary(data),
        };
    }

    private static string[] InstalledLibrary(string data) =>
        [.. (Libraries.Select(library => library.Select(folder => Path.Combine(data, folder)).ToArray())
            .FirstOrDefault(library => Directory.Exists(library[0]) && Directory.EnumerateFiles(library[0], "*.dll").Any()) ?? [])
            .Where(Directory.Exists)];

    private static string[] FlatLibrary(IEnumerable<string> folders) =>
        [.. folders.Where(folder => new[] { "netstandard.dll", "mscorlib.dll" }.Any(file => File.Exists(Path.Combine(folder, file))))
            .Take(1)];

    private static string? PlayerModules(string data)
    {
        var engines = Path.Combine(data, "PlaybackEngines");
        if (!Directory.Exists(engines)) return null;
        var search = new EnumerationOptions { RecurseSubdirectories = true, MaxRecursionDepth = 6 };
        return Directory.EnumerateFiles(engines, CoreModule, search)
            .Select(file => Path.GetDirectoryName(file)!).Order(StringComparer.Ordinal).FirstOrDefault();
    }
}
