namespace Penumbra.ApiCheck.Sources;

/// <summary>
/// The parsed C# of one source. A file without #if is parsed once for all symbol sets. Paths in it read
/// engine/Runtime/…, so that no answer depends on where the folder lies.
/// </summary>
public sealed class RealSource
{
    // These folders are no part of what a project gets from the source: tools, third-party code, tests and samples.
    private static readonly string[] Outside = ["Tools", "External", "Projects", "Tests", "artifacts"];

    // This folder is Unity's own: 6000.5 has some types in it that stood in Runtime/ before.
    private const string OwnExternal = "External/ScriptingCore/";

    private readonly IReadOnlyList<(string Path, string Text)> conditional;
    private readonly IReadOnlyList<SyntaxTree> always;
    private readonly IReadOnlyList<Asmdef> assemblies;

    private RealSource(SourceFolder folder, IReadOnlyList<(string, string)> conditional, IReadOnlyList<SyntaxTree> always,
                       IReadOnlyList<Asmdef> assemblies)
    {
        Folder = folder;
        this.conditional = conditional;
        this.always = always;
        this.assemblies = assemblies;
    }

    public SourceFolder Folder { get; }
    public int Files => conditional.Count + always.Count;

    /// <summary>Whether any file reads differently under different symbols.</summary>
    public bool IsConditional => conditional.Count > 0;

    public static RealSource Read(SourceFolder folder)
    {
        var files = ShippedFiles.Below(folder.Root)
            .Select(file => (File: file, Path: Path.GetRelativePath(folder.Root, file).Replace('\\', '/')))
            .Where(entry => !Outside.Contains(entry.Path.Split('/')[0]) ||
                            entry.Path.StartsWith(OwnExternal, StringComparison.Ordinal)).ToArray();
        var texts = files.Where(entry => entry.Path.EndsWith(".cs", StringComparison.Ordinal)).AsParallel().AsOrdered()
            .Select(entry => (Path: $"{folder.Source}/{entry.Path}", Text: File.ReadAllText(entry.File))).ToArray();
        var conditional = texts.Where(entry => entry.Text.Contains("#if") || entry.Text.Contains("# if")).ToArray();
        var always = texts.Except(conditional).AsParallel().AsOrdered().Select(entry => Parse(entry, [])).ToArray();
        var asmdefs = files.Where(entry => entry.Path.EndsWith(".asmdef", StringComparison.Ordinal))
            .Select(entry => Asmdef.Read(entry.File));
        return new RealSource(folder, conditional, always, [.. asmdefs]);
    }

    public IEnumerable<SyntaxTree> Trees(SymbolSet set, PackageVersions versions)
    {
        string[] modules = set.HasXr ? ["ENABLE_VR_MODULE", "ENABLE_XR_MODULE"] : [];
        var symbols = set.Symbols(versions.Unity).Concat(modules)
            .Concat(assemblies.SelectMany(assembly => versions.Symbols(assembly, set))).Distinct().ToArray();
        var trees = always.Concat(conditional.AsParallel().AsOrdered().Select(entry => Parse(entry, symbols)));
        // The engine's reference is one text for editor and player; of a package a player has no editor's part.
        return set.IsEditor || Folder.Source == SourceFolder.Engine
            ? trees
            : trees.Where(tree => !SourceFolder.IsEditorFile(tree.FilePath));
    }

    private static SyntaxTree Parse((string Path, string Text) entry, IEnumerable<string> symbols) =>
        CSharpSyntaxTree.ParseText(entry.Text,
            new CSharpParseOptions(LanguageVersion.CSharp12, DocumentationMode.None, preprocessorSymbols: symbols), entry.Path);
}
