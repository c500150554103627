using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Penumbra.ApiCheck.Sources;

/// <summary>
/// Compiles the package's C# against the declarations: it must compile, and use nothing of them that is ours
/// ([OwnBehaviour], Penumbra.UnityApi). Code that uses what Unity keeps internal does not compile, as our declarations
/// are an assembly of their own here.
/// </summary>
public sealed class OwnUse(PackageSources package, PackageVersions versions, Findings findings)
{
    /// <summary>
    /// References that tests need beside the declarations: their framework, and the symbol that it comes with.
    /// </summary>
    public IReadOnlyList<MetadataReference> Frameworks { get; init; } = [];
    public IReadOnlyList<string> Symbols { get; init; } = [];

    /// <returns>The declared types from which types of the package derive directly, or which they name as
    /// interfaces.</returns>
    public IReadOnlySet<INamedTypeSymbol> Check(SymbolSet set, CSharpCompilation declarations)
    {
        MetadataReference[] references = [Profile.Reference, declarations.ToMetadataReference(), .. Frameworks];
        var parents = new HashSet<INamedTypeSymbol>(SymbolEqualityComparer.Default);
        foreach (var compilation in new PackageBuild(package, versions, set) { Symbols = Symbols }.Compile(_ => references))
        {
            var name = compilation.AssemblyName!;
            findings.Look(name);
            foreach (var error in PackageBuild.Errors(compilation))
                findings.Add(new Problem(name, Place.Of(error.Location), name, $"{error.Id} {error.GetMessage()}", null));
            foreach (var tree in compilation.SyntaxTrees)
            {
                var model = compilation.GetSemanticModel(tree);
                foreach (var node in tree.GetRoot().DescendantNodes().OfType<SimpleNameSyntax>())
                    CheckName(model, node, declarations.Assembly, set);
                parents.UnionWith(Parents(model, tree.GetRoot()).Where(type => IsOf(type, declarations.Assembly)));
            }
        }
        return parents;
    }

    private static IEnumerable<INamedTypeSymbol> Parents(SemanticModel model, SyntaxNode root) =>
        root.DescendantNodes().OfType<BaseTypeDeclarationSyntax>().Select(node => model.GetDeclaredSymbol(node))
            .OfType<INamedTypeSymbol>().SelectMany(type => type.Interfaces.Append(type.BaseType)).OfType<INamedTypeSymbol>()
            .Select(type => type.OriginalDefinition);

    private static bool IsOf(ISymbol symbol, IAssemblySymbol assembly) =>
        SymbolEqualityComparer.Default.Equals(symbol.ContainingAssembly, assembly);

    private void CheckName(SemanticModel model, SimpleNameSyntax name, IAssemblySymbol declarations, SymbolSet set)
    {
        if (model.GetSymbolInfo(name).Symbol is not { } symbol || symbol is INamespaceSymbol || !IsOf(symbol, declarations))
            return;
        var fault = Declarations.IsOwn(symbol) ? "ours, not Unity's: the package must not use it"
            : !set.IsEditor && symbol is INamedTypeSymbol type && Declarations.IsEditors(type)
                ? "the editor's: a player does not have it, put it under #if UNITY_EDITOR"
                : null;
        if (fault is not null)
            findings.Add(new Problem(model.Compilation.AssemblyName!, Place.Of(name.GetLocation()), Names.Of(symbol), fault,
                                     Place.Of(symbol)));
    }
}
