namespace Penumbra.ApiCheck.Compare;

/// <summary>Compares two members of the same kind and signature, with one sentence for each difference.</summary>
public sealed class MemberComparison(TypeMatch match)
{
    public IEnumerable<string> Differences(ISymbol declared, ISymbol real)
    {
        if (Access.Outside(declared) != Access.Outside(real))
            yield return Names.Differ(Names.Of(declared.DeclaredAccessibility), Names.Of(real.DeclaredAccessibility));
        if (declared.IsStatic != real.IsStatic) yield return Names.Differ(Static(declared), Static(real));
        if (Overriding(declared, real) is { } overriding) yield return overriding;
        var details = (declared, real) switch
        {
            (IMethodSymbol one, IMethodSymbol other) => Methods(one, other),
            (IPropertySymbol one, IPropertySymbol other) => Properties(one, other),
            (IFieldSymbol one, IFieldSymbol other) => Fields(one, other),
            (IEventSymbol one, IEventSymbol other) => Typed("the event", one.Type, other.Type),
            _ => [],
        };
        foreach (var detail in details) yield return detail;
        if (Obsolescence.Of(real) is { IsError: true } mark)
            yield return $"[Obsolete] as an error in the real source: {mark.Message}";
    }

    public IEnumerable<string> Methods(IMethodSymbol declared, IMethodSymbol real) =>
        Returned(declared.ReturnType, declared.RefKind, real.ReturnType, real.RefKind)
            .Concat(Parameters.Differences(declared.Parameters, real.Parameters, match))
            .Concat(declared.IsExtensionMethod == real.IsExtensionMethod
                ? []
                : [Names.Differ(Extension(declared), Extension(real))])
            .Concat(Generics.Differences(declared.TypeParameters, real.TypeParameters, match));

    private IEnumerable<string> Properties(IPropertySymbol declared, IPropertySymbol real) =>
        Returned(declared.Type, declared.RefKind, real.Type, real.RefKind)
            .Concat(Parameters.Differences(declared.Parameters, real.Parameters, match))
            .Concat(Accessor("get", declared.GetMethod, real.GetMethod))
            .Concat(Accessor("set", declared.SetMethod, real.SetMethod));

    private static IEnumerable<string> Accessor(string word, IMethodSymbol? declared, IMethodSymbol? real)
    {
        if (declared is null || !Access.IsReachable(declared) || Declarations.IsOwn(declared)) yield break;
        if (real is null) yield return Names.Differ($"has {word}", "none");
        else if (Access.Outside(declared) != Access.Outside(real))
            yield return Names.Differ($"{word} is {Names.Of(declared.DeclaredAccessibility)}", Names.Of(real.DeclaredAccessibility));
        else if (declared.IsInitOnly != real.IsInitOnly) yield return Names.Differ(Setter(declared), Setter(real));
        if (real is not null && Obsolescence.Of(real) is { IsError: true } mark)
            yield return $"{word} is [Obsolete] as an error in the real source: {mark.Message}";
    }

    private IEnumerable<string> Fields(IFieldSymbol declared, IFieldSymbol real)
    {
        if (declared.ContainingType.TypeKind == TypeKind.Enum)
        {
            if (!Equals(Convert.ToDecimal(declared.ConstantValue), Convert.ToDecimal(real.ConstantValue)))
                yield return Values(declared, real);
            yield break;
        }
        foreach (var difference in Typed("the field", declared.Type, real.Type)) yield return difference;
        if (declared.IsConst != real.IsConst || declared.IsReadOnly != real.IsReadOnly)
            yield return Names.Differ(Storage(declared), Storage(real));
        else if (declared.IsConst && !Equals(declared.ConstantValue, real.ConstantValue))
            yield return Values(declared, real);
    }

    private IEnumerable<string> Returned(ITypeSymbol declared, RefKind declaredBy, ITypeSymbol real, RefKind realBy)
    {
        if (declaredBy != realBy) yield return Names.Differ($"returns {By(declaredBy)}", By(realBy));
        if (!match.Same(declared, real)) yield return Names.Differ($"is of type {Names.Of(declared)}", Names.Of(real));
    }

    private IEnumerable<string> Typed(string what, ITypeSymbol declared, ITypeSymbol real)
    {
        if (!match.Same(declared, real))
            yield return Names.Differ($"{what} is of type {Names.Of(declared)}", Names.Of(real));
    }

    /// <summary>
    /// The problem of overriding: what is abstract must be overridden; what is virtual here must be open to it there.
    /// </summary>
    private static string? Overriding(ISymbol declared, ISymbol real)
    {
        if (declared.ContainingType.TypeKind == TypeKind.Interface) return null;
        if (declared.IsAbstract != real.IsAbstract) return Names.Differ(Abstract(declared), Abstract(real));
        return IsOpen(declared) && !IsOpen(real) ? Names.Differ("can be overridden", "not") : null;
    }

    private static bool IsOpen(ISymbol symbol) =>
        (symbol.IsVirtual || symbol.IsAbstract || symbol.IsOverride) && !symbol.IsSealed && !symbol.ContainingType.IsSealed;

    private static string Values(IFieldSymbol declared, IFieldSymbol real) =>
        Names.Differ($"is {Parameters.Value(declared.ConstantValue)}", Parameters.Value(real.ConstantValue));

    private static string Abstract(ISymbol symbol) => symbol.IsAbstract ? "abstract" : "not abstract";

    private static string Setter(IMethodSymbol accessor) => accessor.IsInitOnly ? "init" : "set";

    private static string Extension(IMethodSymbol method) => method.IsExtensionMethod ? "an extension" : "no extension";

    private static string Static(ISymbol symbol) => symbol.IsStatic ? "static" : "an instance's";

    private static string Storage(IFieldSymbol field) => field.IsConst ? "const" : field.IsReadOnly ? "readonly" : "writable";

    private static string By(RefKind kind) => kind switch
    {
        RefKind.None => "a value",
        RefKind.Ref => "a reference",
        _ => "a readonly reference",
    };
}
