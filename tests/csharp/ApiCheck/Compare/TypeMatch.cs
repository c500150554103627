namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// Tells whether a declared type is the real one: by full name, element by element. Type parameters are one by their
/// place, tuples by their elements' types; nullable annotations and the names of tuple elements do not count. Where the
/// real source names a type that none of the given sources holds, its simple name is all there is; such names are kept.
/// </summary>
public sealed class TypeMatch
{
    /// <summary>Types that were compared by name alone since the last look.</summary>
    public SortedSet<string> ByName { get; } = new(StringComparer.Ordinal);

    public bool Same(ITypeSymbol declared, ITypeSymbol real) => (declared, real) switch
    {
        (_, IErrorTypeSymbol unknown) => SameByName(declared, unknown),
        (IArrayTypeSymbol one, IArrayTypeSymbol other) => one.Rank == other.Rank && Same(one.ElementType, other.ElementType),
        (IPointerTypeSymbol one, IPointerTypeSymbol other) => Same(one.PointedAtType, other.PointedAtType),
        (ITypeParameterSymbol one, ITypeParameterSymbol other) =>
            one.Ordinal == other.Ordinal && one.TypeParameterKind == other.TypeParameterKind,
        (IDynamicTypeSymbol, IDynamicTypeSymbol) => true,
        (INamedTypeSymbol one, INamedTypeSymbol other) => SameNamed(one, other),
        (IFunctionPointerTypeSymbol, IFunctionPointerTypeSymbol) => Names.Of(declared) == Names.Of(real),
        _ => false,
    };

    /// <summary>Whether both have the same types and passing modes, in the same order.</summary>
    private bool SameParameters(IReadOnlyList<IParameterSymbol> declared, IReadOnlyList<IParameterSymbol> real) =>
        declared.Count == real.Count &&
        declared.Zip(real).All(pair => pair.First.RefKind == pair.Second.RefKind && Same(pair.First.Type, pair.Second.Type));

    /// <summary>Whether two members of one name are of the same kind and parameters.</summary>
    public bool SameSignature(ISymbol declared, ISymbol real) => (declared, real) switch
    {
        (IMethodSymbol one, IMethodSymbol other) => one.Arity == other.Arity && SameParameters(one.Parameters, other.Parameters) &&
            (one.MethodKind != MethodKind.Conversion || Same(one.ReturnType, other.ReturnType)),
        (IPropertySymbol one, IPropertySymbol other) => SameParameters(one.Parameters, other.Parameters),
        _ => declared.Kind == real.Kind,
    };

    private bool SameNamed(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        declared = declared.TupleUnderlyingType ?? declared;
        real = real.TupleUnderlyingType ?? real;
        if (declared.MetadataName != real.MetadataName) return false;
        var sameHome = (declared.ContainingType, real.ContainingType) switch
        {
            (null, null) => declared.ContainingNamespace.ToDisplayString() == real.ContainingNamespace.ToDisplayString(),
            ({ } one, { } other) => SameNamed(one, other),
            _ => false,
        };
        return sameHome && SameArguments(declared, real);
    }

    private bool SameArguments(INamedTypeSymbol declared, INamedTypeSymbol real) =>
        declared.TypeArguments.Length == real.TypeArguments.Length &&
        declared.TypeArguments.Zip(real.TypeArguments).All(pair => Same(pair.First, pair.Second));

    private bool SameByName(ITypeSymbol declared, IErrorTypeSymbol real)
    {
        // Where a name means several types, as the text stands, one of them is meant.
        if (real.CandidateSymbols.OfType<ITypeSymbol>().Any(candidate => Same(declared, candidate))) return true;
        if (declared is not INamedTypeSymbol named || named.MetadataName != real.MetadataName || !SameArguments(named, real))
            return false;
        ByName.Add(Names.Of(declared));
        return true;
    }
}
