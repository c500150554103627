namespace Penumbra.ApiCheck.Sources;

/// <summary>A folder with the C# of the engine, of core or of URP, and the version it says it has.</summary>
public sealed record SourceFolder(string Source, string Root, string Version, string VersionFrom)
{
    public const string Engine = "engine";
    public const string Core = "core";
    public const string Universal = "universal";

    public static readonly IReadOnlyList<string> All = [Engine, Core, Universal];

    /// <summary>
    /// Opens the folder, which is Unity's public C# reference or the package that the source is named for.
    /// </summary>
    public static SourceFolder Open(string source, string folder)
    {
        if (!Directory.Exists(folder)) throw CheckException.Usage($"{folder}: there is no such folder");
        var from = source == Engine ? "README.md" : "package.json";
        var file = Path.Combine(folder, from);
        if (!File.Exists(file)) throw CheckException.Usage($"{folder}: there is no {from}, which says the version of {source}");
        // The reference names its version in the first line.
        var version = source == Engine
            ? UnityVersion.Find(File.ReadLines(file).FirstOrDefault() ?? "")?.Text
            : JsonFile.Read(file, root => root.GetProperty("version").GetString());
        return new SourceFolder(source, folder, version ?? throw CheckException.Usage($"{file}:1:1: it says no version"), from);
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
}
