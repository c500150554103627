namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// Compares every declared type with that of its name in the sources, under one symbol set. `parents` are the declared
/// types from which the package derives types of its own.
/// </summary>
public sealed class ApiComparison(IReadOnlyDictionary<string, CSharpCompilation> real, bool isEditor,
                                  IReadOnlySet<INamedTypeSymbol> parents, Findings findings)
{
    private const string Faulty = "declaration";

    public void Compare(CSharpCompilation declarations)
    {
        findings.Look(Faulty);
        foreach (var error in declarations.GetDeclarationDiagnostics().Where(one => one.Severity == DiagnosticSeverity.Error))
            findings.Add(new(Faulty, Report.Place.Of(error.Location), Faulty, $"{error.Id} {error.GetMessage()}", null));
        foreach (var type in Declarations.Types(declarations).Where(Access.IsReachable)) CompareTop(type);
    }

    private void CompareTop(INamedTypeSymbol declared)
    {
        if (Declarations.IsEditors(declared) && !isEditor) return;
        findings.Look(Names.Of(declared));
        foreach (var (name, source) in real)
        {
            if (source.Assembly.GetTypeByMetadataName(MetadataName(declared)) is not { } type) continue;
            var result = findings.Type(declared, name);
            result.Members.UnionWith(Signature.AllOf(declared));
            new TypeMembers(result, findings, parents).Compare(declared, type);
            return;
        }
        findings.Add(declared, Absent(declared, out var near), near);
    }

    /// <summary>
    /// The problem of a type that is not there: it names where one of that name is, or one of nearly that name.
    /// </summary>
    private string Absent(INamedTypeSymbol declared, out ISymbol? near)
    {
        const string absent = "no source has such a type: mark it [OwnBehaviour] if it is ours";
        near = real.Values.SelectMany(source => source.GetSymbolsWithName(declared.Name, SymbolFilter.Type)).FirstOrDefault();
        if (near is not null) return $"no source has such a type, but {Names.Of(near)}";
        var beside = real.Values.SelectMany(source => Namespace(source, declared)?.GetTypeMembers() ?? []);
        near = Names.Nearest(declared.Name, beside, type => type.Name);
        return near is null ? absent : $"no source has such a type; the nearest is {Names.Of(near)}";
    }

    private static INamespaceSymbol? Namespace(Compilation source, INamedTypeSymbol declared)
    {
        INamespaceSymbol? at = source.Assembly.GlobalNamespace;
        if (declared.ContainingNamespace.IsGlobalNamespace) return at;
        foreach (var part in declared.ContainingNamespace.ToDisplayString().Split('.'))
            at = at?.GetNamespaceMembers().FirstOrDefault(space => space.Name == part);
        return at;
    }

    private static string MetadataName(INamedTypeSymbol type) => type.ContainingNamespace.IsGlobalNamespace
        ? type.MetadataName
        : $"{type.ContainingNamespace.ToDisplayString()}.{type.MetadataName}";
}
