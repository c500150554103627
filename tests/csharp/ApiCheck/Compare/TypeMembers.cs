namespace Penumbra.ApiCheck.Compare;

/// <summary>Compares one declared type with the real one, with its members and nested types.</summary>
public sealed class TypeMembers(TypeResult result, Findings findings, IReadOnlySet<INamedTypeSymbol> parents)
{
    private readonly TypeMatch match = new();

    public void Compare(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        var comparison = new TypeComparison(match);
        // A partial type has several files; those of its compared members count, where it has any.
        if (!declared.GetMembers().Any(Signature.IsCompared)) NoteFile(real);
        foreach (var difference in comparison.Differences(declared, real)) findings.Add(declared, difference, real);
        Note(declared, real);
        if (declared.TypeKind != real.TypeKind || declared.TypeKind == TypeKind.Delegate) return;
        foreach (var missing in parents.Contains(declared) ? TypeComparison.Required(real) : [])
        {
            if (!comparison.Has(declared, missing))
                findings.Add(declared, $"the package has a type of it, which must have {Names.ShortOf(missing)}: declare it", missing);
        }
        if (TypeComparison.Construction(declared, real) is { } construction)
            findings.Add(declared, construction, real);
        foreach (var member in declared.GetMembers().Where(Signature.IsCompared)) CompareMember(member, real);
        result.ByName.UnionWith(match.ByName);
    }

    private void CompareMember(ISymbol declared, INamedTypeSymbol type)
    {
        if (declared is INamedTypeSymbol nested)
        {
            if (type.GetTypeMembers(nested.Name, nested.Arity).FirstOrDefault() is { } other) Compare(nested, other);
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
        else NoteFile(real);
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

    private void NoteFile(ISymbol real)
    {
        if (Place.Of(real) is { } place) result.Files.Add(place.File);
    }
}
