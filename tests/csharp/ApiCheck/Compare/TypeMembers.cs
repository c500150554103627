namespace Penumbra.ApiCheck.Compare;

/// <summary>Compares one declared type with the real one, with its members and nested types.</summary>
public sealed class TypeMembers(TypeResult result, Findings findings, string generation,
                                IReadOnlySet<INamedTypeSymbol> parents)
{
    private readonly TypeMatch match = new();

    public void Compare(INamedTypeSymbol declared, INamedTypeSymbol real, IReadOnlyList<ReadFrom> origins)
    {
        var comparison = new TypeComparison(match);
        CheckPlace(declared, real, origins);
        var files = Files(origins);
        result.Versions.UnionWith(origins.Where(origin => origin.InGeneration() == generation)
            .Select(origin => (origin.Source, origin.Version)));
        foreach (var difference in comparison.Differences(declared, real))
            findings.Add(declared, difference, real, files);
        Note(declared, real);
        if (declared.TypeKind != real.TypeKind || declared.TypeKind == TypeKind.Delegate) return;
        foreach (var missing in parents.Contains(declared) ? TypeComparison.Required(real) : [])
        {
            if (!comparison.Has(declared, missing))
                findings.Add(declared, $"the package has a type of it, which must have {Names.ShortOf(missing)}: declare it", missing);
        }
        if (TypeComparison.Construction(declared, real) is { } construction)
            findings.Add(declared, construction, real, files);
        foreach (var member in declared.GetMembers().Where(Signature.IsCompared)) CompareMember(member, real, origins);
        result.ByName.UnionWith(match.ByName);
    }

    private void CompareMember(ISymbol declared, INamedTypeSymbol type, IReadOnlyList<ReadFrom> origins)
    {
        var own = Declarations.Origins(declared, generation);
        var read = own.Length > 0 ? own : origins;
        if (declared is INamedTypeSymbol nested)
        {
            if (type.GetTypeMembers(nested.Name, nested.Arity).FirstOrDefault() is { } other)
                Compare(nested, other, read);
            else findings.Add(declared, Absent(declared, type, out var near), near ?? type);
            return;
        }

        var candidates = MemberSearch.Find(type, declared.Name);
        var real = candidates.Concat(MemberSearch.Everywhere(type, declared.Name)).FirstOrDefault(other => match.SameSignature(declared, other));
        if (real is null)
        {
            findings.Add(declared, Unmatched(declared, type, candidates, out var near), near ?? type);
            return;
        }
        foreach (var difference in Facts.Differences(Facts.OfMember(declared), Facts.OfMember(real), match))
            findings.Add(declared, difference, real);
        Note(declared, real);
        if (!SymbolEqualityComparer.Default.Equals(real.ContainingType.OriginalDefinition, type.OriginalDefinition))
            result.Inherited.Add(Names.Of(declared) + " of " + Names.Of(real.ContainingType));
        else CheckPlace(declared, real, read);
    }

    private string Unmatched(ISymbol declared, INamedTypeSymbol type, IReadOnlyList<ISymbol> candidates, out ISymbol? near)
    {
        near = candidates.FirstOrDefault(Access.IsReachable) ?? candidates.FirstOrDefault();
        if (near is null) return Absent(declared, type, out near);
        if (near.Kind != declared.Kind) return Names.Differ(Kind(declared), Kind(near));
        var likely = candidates.OfType<IMethodSymbol>().Where(Access.IsReachable).ToArray();
        if (declared is IMethodSymbol { MethodKind: not MethodKind.Conversion } method && likely is [var only] &&
            only.Arity == method.Arity)
            return Differ(method.Parameters, only.Parameters);
        if (declared is IPropertySymbol property && near is IPropertySymbol other)
            return Differ(property.Parameters, other.Parameters);
        var overloads = likely.Length > 0 ? likely : candidates.ToArray();
        return $"no overload has these parameters; the real ones are {string.Join(", ", overloads.Select(Names.ShortOf))}";
    }

    private string Differ(IReadOnlyList<IParameterSymbol> declared, IReadOnlyList<IParameterSymbol> real) =>
        string.Join("; ", Facts.Differences(Facts.OfParameters(declared), Facts.OfParameters(real), match));

    private static string Absent(ISymbol declared, INamedTypeSymbol type, out ISymbol? near)
    {
        var names = MemberSearch.Above(type).Prepend(type).SelectMany(other => other.GetMembers())
            .Where(member => member.CanBeReferencedByName && Access.IsReachable(member));
        near = Names.Nearest(declared.Name, names, member => member.Name);
        return "the real type has no such member" + (near is null ? "" : $"; the nearest is {near.Name}");
    }

    private static string Kind(ISymbol symbol) => symbol.Kind switch
    {
        SymbolKind.NamedType => "a type",
        SymbolKind.Event => "an event",
        var kind => "a " + kind.ToString().ToLowerInvariant(),
    };

    private void Note(ISymbol declared, ISymbol real)
    {
        if (Facts.Obsolete(real) is { } mark && !mark.ConstructorArguments.Any(argument => argument.Value is true))
            result.Obsolete.Add(Names.Of(declared));
    }

    private static string[] Files(IEnumerable<ReadFrom> origins) =>
        [.. origins.Select(origin => $"{origin.Source}/{origin.Path}")];

    /// <summary>Checks that the real symbol stands in a file that the declaration names.</summary>
    private void CheckPlace(ISymbol declared, ISymbol real, IReadOnlyList<ReadFrom> origins)
    {
        var named = Files(origins);
        var standing = real.Locations.Where(place => place.IsInSource).Select(place => place.SourceTree!.FilePath).ToHashSet();
        result.Files.UnionWith(named.Intersect(standing));
        if (standing.Count > 0 && !standing.Intersect(named).Any())
            findings.Add(declared, $"[ReadFrom] names {string.Join(", ", named)}; it stands in " + string.Join(", ", standing), real);
    }
}
