using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// Assemblies with the names and the division of Unity's, compiled from our declarations: each declared type goes
/// where the file that it was read in would put it. They stand in for an installation that is not here.
/// </summary>
public static class UnityAssemblies
{
    public sealed record Part(string Name, string Source, bool IsEditor);

    /// <summary>The parts in the order in which they refer to each other.</summary>
    public static readonly IReadOnlyList<Part> Parts =
    [
        new("UnityEngine.CoreModule", SourceFolder.Engine, false),
        new("UnityEditor.CoreModule", SourceFolder.Engine, true),
        new("Unity.RenderPipelines.Core.Runtime", SourceFolder.Core, false),
        new("Unity.RenderPipelines.Core.Editor", SourceFolder.Core, true),
        new("Unity.RenderPipelines.Universal.Runtime", SourceFolder.Universal, false),
        new("Unity.RenderPipelines.Universal.Editor", SourceFolder.Universal, true),
    ];

    private static readonly Dictionary<(string Generation, string? Without), IReadOnlyDictionary<string, byte[]>> Made = [];

    /// <param name="without">Full name of a member to leave out, such as UnityEngine.Mathf.Clamp.</param>
    /// <returns>The assemblies' bytes by name.</returns>
    public static IReadOnlyDictionary<string, byte[]> Make(string generation, string? without = null)
    {
        if (!Made.TryGetValue((generation, without), out var made))
            Made[(generation, without)] = made = Compile(generation, without);
        return made;
    }

    /// <summary>An assembly of one source on .NET Standard.</summary>
    public static byte[] Emit(string name, string source) => Emit(CSharpCompilation.Create(name, [CSharpSyntaxTree.ParseText(source)],
        [Profile.Reference], new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary)));

    private static Dictionary<string, byte[]> Compile(string generation, string? without)
    {
        var whole = new Declarations(Repository.At("tests/csharp/UnityApi"), generation, Repository.Root)
            .Compile(SymbolSet.All[0], UnityVersion.Parse(generation));
        var references = new List<MetadataReference> { Profile.Reference };
        var made = new Dictionary<string, byte[]>();
        foreach (var part in Parts)
        {
            var options = whole.SyntaxTrees.First().Options;
            var trees = whole.SyntaxTrees.Select(tree => Pruned(tree, whole, part, generation, without))
                .Append(CSharpSyntaxTree.ParseText(Surroundings(whole), (CSharpParseOptions)options));
            var image = Emit(CSharpCompilation.Create(part.Name, trees, references, whole.Options));
            references.Add(MetadataReference.CreateFromImage(image));
            made[part.Name] = image;
        }
        return made;
    }

    private static byte[] Emit(Compilation compilation)
    {
        using var stream = new MemoryStream();
        var result = compilation.Emit(stream);
        if (!result.Success)
            throw new InvalidOperationException($"{compilation.AssemblyName} does not compile: " + string.Join("\n",
                result.Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error).Take(10)));
        return stream.ToArray();
    }

    /// <summary>Each part sees the others' internals, and every namespace that a using names exists.</summary>
    private static string Surroundings(Compilation whole)
    {
        var friends = Parts.Select(part => $"[assembly: System.Runtime.CompilerServices.InternalsVisibleTo(\"{part.Name}\")]");
        var spaces = whole.SyntaxTrees.SelectMany(tree => tree.GetRoot().DescendantNodes().OfType<UsingDirectiveSyntax>())
            .Where(use => use is { Alias: null, StaticKeyword.RawKind: 0 }).Select(use => use.Name!.ToString()).Distinct()
            .Select(name => $"namespace {name} {{ }}");
        return string.Join("\n", friends.Concat(spaces));
    }

    private static SyntaxTree Pruned(SyntaxTree tree, Compilation whole, Part part, string generation, string? without)
    {
        var model = whole.GetSemanticModel(tree);
        var root = tree.GetRoot();
        var types = root.DescendantNodes(node => node is CompilationUnitSyntax or BaseNamespaceDeclarationSyntax)
            .Where(node => node is BaseTypeDeclarationSyntax or DelegateDeclarationSyntax).ToArray();
        var home = types.Select(type => Home(model.GetDeclaredSymbol(type)!, generation)).FirstOrDefault(found => found is not null);
        var others = types.Where(type => (Home(model.GetDeclaredSymbol(type)!, generation) ?? home ?? Parts[0]) != part);
        var members = root.DescendantNodes().OfType<MemberDeclarationSyntax>().Where(member =>
            without is not null && model.GetDeclaredSymbol(member) is { } symbol &&
            $"{symbol.ContainingType?.ToDisplayString()}.{symbol.Name}" == without);
        var pruned = root.RemoveNodes(others.Concat(members), SyntaxRemoveOptions.KeepUnbalancedDirectives)!;
        return tree.WithRootAndOptions(pruned, tree.Options);
    }

    private static Part? Home(ISymbol type, string generation) =>
        Declarations.Origins(type, generation).FirstOrDefault() is { } origin
            ? Parts.Single(part => part.Source == origin.Source && part.IsEditor == SourceFolder.IsEditorFile(origin.Path))
            : null;
}
