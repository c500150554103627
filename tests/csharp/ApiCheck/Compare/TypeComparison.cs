namespace Penumbra.ApiCheck.Compare;

/// <summary>Compares two types of the same name, their members apart, with one sentence for each difference.</summary>
public sealed class TypeComparison(TypeMatch match)
{
    public IEnumerable<string> Differences(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        if (Access.Outside(declared) != Access.Outside(real))
            yield return Names.Differ(Names.Of(declared.DeclaredAccessibility), Names.Of(real.DeclaredAccessibility));
        if (declared.TypeKind != real.TypeKind)
        {
            yield return Names.Differ($"a {Names.Of(declared.TypeKind)}", $"a {Names.Of(real.TypeKind)}");
            yield break;
        }
        var differences = Modifiers(declared, real)
            .Concat(Generics.Differences(declared.TypeParameters, real.TypeParameters, match))
            .Concat(Inheritance(declared, real)).Concat(Attribute(declared, real));
        foreach (var difference in differences) yield return difference;
        if (declared.EnumUnderlyingType is { } one && real.EnumUnderlyingType is { } other && !match.Same(one, other))
            yield return Names.Differ($"its values are {Names.Of(one)}", Names.Of(other));
        if (declared.DelegateInvokeMethod is { } call && real.DelegateInvokeMethod is { } realCall)
        {
            foreach (var difference in new MemberComparison(match).Methods(call, realCall)) yield return difference;
        }
        if (Obsolescence.Of(real) is { IsError: true } mark)
            yield return $"[Obsolete] as an error in the real source: {mark.Message}";
    }

    /// <summary>
    /// The abstract members that no type in between overrides, which a type that derives from it must have.
    /// </summary>
    public static IEnumerable<ISymbol> Required(INamedTypeSymbol real)
    {
        var overridden = new HashSet<ISymbol>(SymbolEqualityComparer.Default);
        foreach (var member in MemberSearch.Above(real).Prepend(real).SelectMany(type => type.GetMembers()))
        {
            if (member is IMethodSymbol { AssociatedSymbol: not null } || !Access.IsReachable(member) || member.IsStatic)
                continue;
            if (member.IsAbstract && !overridden.Contains(member.OriginalDefinition)) yield return member;
            ISymbol? below = (member as IMethodSymbol)?.OverriddenMethod;
            below ??= (member as IPropertySymbol)?.OverriddenProperty;
            if (below is not null) overridden.Add(below.OriginalDefinition);
        }
    }

    /// <summary>The problem of construction: a class that can be made with new here must be open to it there.</summary>
    public static string? Construction(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        if (declared.TypeKind != TypeKind.Class || declared.IsStatic ||
            declared.InstanceConstructors is not [{ IsImplicitlyDeclared: true }])
            return null;
        var needed = declared.IsAbstract ? Accessibility.Protected : Accessibility.Public;
        return real.InstanceConstructors.Any(made => made.Parameters.Length == 0 && Access.Outside(made) >= needed)
            ? null
            : "can be made with new() here, not in the real source: declare a private constructor, or those that it has";
    }

    /// <summary>Whether the declared type has the member, be it its own or inherited.</summary>
    public bool Has(INamedTypeSymbol declared, ISymbol member) =>
        MemberSearch.Everywhere(declared, member.Name).Any(own => SameParameters(own, member));

    private bool SameParameters(ISymbol declared, ISymbol real) => (declared, real) switch
    {
        (IMethodSymbol one, IMethodSymbol other) => match.SameParameters(one.Parameters, other.Parameters),
        (IPropertySymbol one, IPropertySymbol other) => match.SameParameters(one.Parameters, other.Parameters),
        _ => declared.Kind == real.Kind,
    };

    private static IEnumerable<string> Modifiers(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        if (declared.TypeKind == TypeKind.Class && Modifier(declared) != Modifier(real))
            yield return Names.Differ(Modifier(declared), Modifier(real));
        if (declared.IsRefLikeType != real.IsRefLikeType)
            yield return Names.Differ(RefStruct(declared), RefStruct(real));
    }

    private static string RefStruct(ITypeSymbol type) => type.IsRefLikeType ? "a ref struct" : "no ref struct";

    private static string Modifier(INamedTypeSymbol type) =>
        type.IsStatic ? "static" : type.IsAbstract ? "abstract" : type.IsSealed ? "sealed" : "open";

    private IEnumerable<string> Inheritance(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        if (declared.TypeKind == TypeKind.Class && declared.BaseType is { SpecialType: not SpecialType.System_Object } parent &&
            !MemberSearch.Above(real).Any(type => match.Same(parent, type)))
            yield return Names.Differ($"derives from {Names.Of(parent)}", Parent(real));
        foreach (var type in declared.Interfaces.Where(type => !real.AllInterfaces.Any(other => match.Same(type, other))))
            yield return Names.Differ($"implements {Names.Of(type)}", "not");
    }

    private static string Parent(INamedTypeSymbol real) =>
        real.BaseType is { SpecialType: not SpecialType.System_Object } parent ? $"from {Names.Of(parent)}" : "from no class";

    /// <summary>The problem of an attribute, which must not be allowed here where the real one is not.</summary>
    private static IEnumerable<string> Attribute(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        if (Usage(declared) is not { } one || Usage(real) is not { } other) yield break;
        if ((one.Targets & ~other.Targets) != 0)
            yield return Names.Differ($"may stand on {one.Targets}", $"on {other.Targets}");
        if (one.Often && !other.Often) yield return Names.Differ("may stand on one thing several times", "not");
    }

    /// <summary>The usage of an attribute: without AttributeUsage it has that of the class it derives from.</summary>
    private static (AttributeTargets Targets, bool Often)? Usage(INamedTypeSymbol type)
    {
        var line = MemberSearch.Above(type).Prepend(type).ToArray();
        if (!line.Any(parent => parent.ToDisplayString() == "System.Attribute")) return null;
        var usage = line.SelectMany(parent => parent.GetAttributes())
            .First(attribute => attribute.AttributeClass?.ToDisplayString() == "System.AttributeUsageAttribute");
        var often = usage.NamedArguments.Any(argument => argument is { Key: "AllowMultiple", Value.Value: true });
        return ((AttributeTargets)(int)usage.ConstructorArguments[0].Value!, often);
    }
}
