namespace Penumbra.ApiCheck.Package;

/// <summary>
/// One assembly definition file: the assembly's name, what it refers to, when it is compiled and which symbols it
/// defines. The fields follow Unity's manual, "Assembly Definition file format".
/// </summary>
public sealed record Asmdef(string File, string Name)
{
    public IReadOnlyList<string> References { get; init; } = [];
    public IReadOnlyList<string> DefineConstraints { get; init; } = [];
    public IReadOnlyList<string> IncludePlatforms { get; init; } = [];
    public IReadOnlyList<string> ExcludePlatforms { get; init; } = [];
    public IReadOnlyList<VersionDefine> VersionDefines { get; init; } = [];
    public bool AllowsUnsafeCode { get; init; }

    public string Folder => Path.GetDirectoryName(File)!;

    /// <summary>Whether the assembly is compiled for the editor alone.</summary>
    public bool IsEditorOnly => IncludePlatforms is ["Editor"];

    public static Asmdef Read(string file) => JsonFile.Read(file, root =>
    {
        var name = Text(root, "name");
        if (name.Length == 0) throw CheckException.Usage($"{file}:1:1: the assembly has no name: add \"name\"");
        return new Asmdef(file, name)
        {
            References = Texts(root, "references"), DefineConstraints = Texts(root, "defineConstraints"),
            IncludePlatforms = Texts(root, "includePlatforms"), ExcludePlatforms = Texts(root, "excludePlatforms"),
            VersionDefines = Defines(file, root),
            AllowsUnsafeCode = root.TryGetProperty("allowUnsafeCode", out var allowed) && allowed.ValueKind == JsonValueKind.True,
        };
    });

    /// <summary>
    /// The constraint that keeps the assembly from being compiled under these symbols; null where none does.
    /// </summary>
    public string? UnmetConstraint(IReadOnlySet<string> symbols) => DefineConstraints.FirstOrDefault(
        constraint => !constraint.Split("||").Any(term => Holds(term.Trim(), symbols)));

    private static bool Holds(string term, IReadOnlySet<string> symbols) =>
        term.StartsWith('!') ? !symbols.Contains(term[1..].Trim()) : symbols.Contains(term);

    private static IReadOnlyList<VersionDefine> Defines(string file, JsonElement root)
    {
        if (!root.TryGetProperty("versionDefines", out var list)) return [];
        return list.EnumerateArray().Select(entry =>
        {
            var expression = Text(entry, "expression");
            var range = VersionRange.Parse(expression) ?? throw CheckException.Usage(
                $"{file}:1:1: '{expression}' is not a version expression such as 14.0.0 or [14.0,17.0)");
            return new VersionDefine(Text(entry, "name"), range, Text(entry, "define"));
        }).ToArray();
    }

    private static string Text(JsonElement element, string name) =>
        element.TryGetProperty(name, out var value) ? value.GetString() ?? "" : "";

    private static string[] Texts(JsonElement element, string name) => element.TryGetProperty(name, out var list)
        ? list.EnumerateArray().Select(item => item.GetString() ?? "").ToArray()
        : [];
}

/// <summary>A symbol that is defined where a package's version lies in a range.</summary>
public sealed record VersionDefine(string Package, VersionRange Range, string Symbol);
