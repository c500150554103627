namespace Penumbra.ApiCheck.Compare;

/// <summary>Compares two types of the same name, their members apart, with one sentence for each difference.</summary>
public sealed class TypeComparison(TypeMatch match)
{
    public IEnumerable<string> Differences(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        // Access and kind come first; more cannot be compared of two kinds.
        if (declared.TypeKind != real.TypeKind) return Facts.Differences(Facts.OfType(declared).Take(2), Facts.OfType(real).Take(2), match);
        return Facts.Differences(Facts.OfType(declared), Facts.OfType(real), match)
            .Concat(Inheritance(declared, real)).Concat(Attribute(declared, real));
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
        MemberSearch.Everywhere(declared, member.Name).Any(own => match.SameSignature(own, member));

    private IEnumerable<string> Inheritance(INamedTypeSymbol declared, INamedTypeSymbol real)
    {
        if (declared.TypeKind == TypeKind.Class && declared.BaseType is { SpecialType: not SpecialType.System_Object } parent &&
            !MemberSearch.Above(real).Any(type => match.Same(parent, type)))
            yield return Names.Differ($"derives from {Names.Of(parent)}", real.BaseType is { } other ? $"from {Names.Of(other)}" : "from nothing");
        foreach (var type in declared.Interfaces.Where(type => !real.AllInterfaces.Any(other => match.Same(type, other))))
            yield return Names.Differ($"implements {Names.Of(type)}", "not");
    }

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
