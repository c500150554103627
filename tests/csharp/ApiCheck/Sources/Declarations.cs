namespace Penumbra.ApiCheck.Sources;

/// <summary>
/// Our declarations of Unity's API for one generation: Shared/, the generation's folder and that of the one it takes
/// over, as the compiler sees them.
/// </summary>
public sealed class Declarations
{
    public const string OwnNamespace = "Penumbra.UnityApi";
    private const string OwnBehaviourName = "OwnBehaviourAttribute";

    private readonly string[] files;
    private readonly string root, shownFrom;

    public Declarations(string root, string generation, string shownFrom)
    {
        (this.root, this.shownFrom) = (root, shownFrom);
        var folders = Generation.Line(generation).Prepend("Shared").Select(folder => Path.Combine(root, folder));
        files = [.. folders.Where(Directory.Exists).SelectMany(ShippedFiles.Below)
            .Where(file => file.EndsWith(".cs", StringComparison.Ordinal))];
        if (files.Length == 0)
            throw CheckException.Usage($"{root}: no declarations in Shared/ or {generation}/: --declarations DIR names " +
                                       "another folder");
    }

    public string Root => root;

    public CSharpCompilation Compile(SymbolSet set, UnityVersion version)
    {
        var options = new CSharpParseOptions(LanguageVersion.CSharp12, DocumentationMode.None,
                                             preprocessorSymbols: set.Symbols(version));
        var trees = files.Select(file => CSharpSyntaxTree.ParseText(File.ReadAllText(file), options,
            Path.GetRelativePath(shownFrom, file).Replace('\\', '/')));
        return CSharpCompilation.Create("UnityApi", trees, [Profile.Reference],
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true));
    }

    /// <summary>The types that stand for Unity's: they are not nested and not ours.</summary>
    public static IEnumerable<INamedTypeSymbol> Types(Compilation compilation) =>
        In(compilation.Assembly.GlobalNamespace).Where(type => !IsOwn(type));

    /// <summary>
    /// Whether a symbol is ours: it is marked as our behaviour, within something marked so, or one of the attributes
    /// themselves.
    /// </summary>
    public static bool IsOwn(ISymbol symbol)
    {
        for (var at = symbol; at is not null && at is not INamespaceSymbol; at = at.ContainingSymbol)
        {
            if (at.GetAttributes().Any(attribute => Is(attribute, OwnBehaviourName))) return true;
        }
        var space = symbol.ContainingNamespace?.ToDisplayString() ?? "";
        return space == OwnNamespace || space.StartsWith(OwnNamespace + ".", StringComparison.Ordinal);
    }

    /// <summary>Whether a player does not have the type: the editor's stand in a namespace of their own.</summary>
    public static bool IsEditors(INamedTypeSymbol type) =>
        $"{type.ContainingNamespace.ToDisplayString()}.".StartsWith("UnityEditor.", StringComparison.Ordinal);

    private static bool Is(AttributeData attribute, string name) =>
        attribute.AttributeClass is { } type && type.Name == name && type.ContainingNamespace.ToDisplayString() == OwnNamespace;

    private static IEnumerable<INamedTypeSymbol> In(INamespaceSymbol space) =>
        space.GetTypeMembers().Concat(space.GetNamespaceMembers().SelectMany(In));
}
