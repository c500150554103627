namespace Penumbra.ApiCheck.Sources;

/// <summary>A folder with the C# of the engine, of core or of URP, and the version it says it has.</summary>
public sealed record SourceFolder(string Source, string Root, string? Version, string VersionFrom)
{
    public const string Engine = "engine";
    public const string Core = "core";
    public const string Universal = "universal";

    public static readonly IReadOnlyList<string> All = [Engine, Core, Universal];

    /// <summary>
    /// The source that the folder holds, known by what only it has; null where it is none of the three.
    /// </summary>
    public static string? Recognise(string folder)
    {
        string[] engine = [Path.Combine(folder, "Runtime", "Export"), Path.Combine(folder, "Editor", "Mono")];
        if (engine.All(Directory.Exists)) return Engine;
        var name = PackageField(folder, "name");
        if (name == PackageVersions.Core || HasAssembly(folder, "Unity.RenderPipelines.Core.Runtime")) return Core;
        if (name == PackageVersions.Universal || HasAssembly(folder, "Unity.RenderPipelines.Universal.Runtime"))
            return Universal;
        return null;
    }

    /// <param name="given">The version that the command names for a folder that does not say its own.</param>
    public static SourceFolder Open(string source, string folder, string? given)
    {
        if (!Directory.Exists(folder)) throw CheckException.Usage($"{folder}: there is no such folder");
        var (found, from) = source == Engine ? EngineVersion(folder) : (PackageField(folder, "version"), "package.json");
        if (found is not null && given is not null && found != given)
            throw CheckException.Usage($"{folder} says in {from} that it is {found}, the command says {given}");
        return found is not null
            ? new SourceFolder(source, folder, found, from)
            : new SourceFolder(source, folder, given, given is null ? "unknown" : "given");
    }

    /// <summary>
    /// Whether a file of the source belongs to the editor alone: a folder Editor, or a module named so.
    /// </summary>
    public static bool IsEditorFile(string path)
    {
        var folders = path.Split('/')[..^1];
        return folders.Contains("Editor") ||
               (folders.Length > 1 && folders[0] == "Modules" && folders[1].EndsWith("Editor", StringComparison.Ordinal));
    }

    private static bool HasAssembly(string folder, string name) =>
        File.Exists(Path.Combine(folder, "Runtime", name + ".asmdef"));

    private static (string?, string) EngineVersion(string folder)
    {
        // Unity's public C# reference names its version in the first line of its README.
        var readme = Path.Combine(folder, "README.md");
        var line = File.Exists(readme) ? File.ReadLines(readme).FirstOrDefault() ?? "" : "";
        return (UnityVersion.Find(line)?.Text, "README.md");
    }

    private static string? PackageField(string folder, string field)
    {
        var file = Path.Combine(folder, "package.json");
        if (!File.Exists(file)) return null;
        return JsonFile.Read(file, root =>
            root.TryGetProperty(field, out var value) && value.ValueKind == JsonValueKind.String ? value.GetString() : null);
    }
}
