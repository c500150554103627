namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// Compares every declared type with the source that it names, under one symbol set. `parents` are the declared types
/// from which the package derives types of its own.
/// </summary>
public sealed class ApiComparison(IReadOnlyDictionary<string, CSharpCompilation> real, string generation, bool isEditor,
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
        var origins = Declarations.Origins(declared, generation);
        if (origins.Length > 0 && origins.All(origin => SourceFolder.IsEditorFile(origin.Path)) && !isEditor) return;
        findings.Look(Names.Of(declared));
        if (origins.Length == 0)
        {
            findings.Add(declared, $"says of no source of {generation} where it was read: add [ReadFrom], or [OwnBehaviour] if " +
                                   "it is ours");
            return;
        }
        var result = findings.Type(declared, origins[0].Source);
        result.Members.UnionWith(Signature.AllOf(declared, generation));
        if (!real.TryGetValue(origins[0].Source, out var source))
        {
            findings.Add(declared, $"was read in {origins[0].Source}, which is not among the sources given");
            return;
        }
        if (Find(source, declared) is { } type)
            new TypeMembers(result, findings, generation, parents).Compare(declared, type, origins);
        else findings.Add(declared, Absent(origins[0].Source, source, declared, out var near), near);
    }

    private static INamedTypeSymbol? Find(Compilation source, INamedTypeSymbol declared) =>
        source.Assembly.GetTypeByMetadataName(MetadataName(declared));

    /// <summary>
    /// The problem of a type that is not there: it names where one of that name is, or one of nearly that name.
    /// </summary>
    private string Absent(string name, Compilation source, INamedTypeSymbol declared, out ISymbol? near)
    {
        near = real.Values.Select(other => Find(other, declared)).FirstOrDefault(type => type is not null);
        if (near is not null)
            return $"the source of {name} has no such type, that of {near.Locations[0].SourceTree!.FilePath.Split('/')[0]} has";
        near = source.GetSymbolsWithName(declared.Name, SymbolFilter.Type).FirstOrDefault();
        if (near is not null) return $"the source of {name} has no such type, but {Names.Of(near)}";
        near = Namespace(source, declared) is { } space
            ? Names.Nearest(declared.Name, space.GetTypeMembers(), type => type.Name)
            : null;
        return $"the source of {name} has no such type" + (near is null ? "" : $"; the nearest is {Names.Of(near)}");
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
