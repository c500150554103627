using System.Globalization;

namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// One thing that a declaration says and the real source must say too. Types are compared by TypeMatch, other values
/// as they are; a declaration whose value is null says nothing.
/// </summary>
public sealed record Fact(string What, object? Value, string Shown);

/// <summary>
/// The facts of a type or member that are compared. Those of two symbols of one kind stand at the same places.
/// </summary>
public static class Facts
{
    /// <summary>The differences, one sentence each.</summary>
    public static IEnumerable<string> Differences(IEnumerable<Fact> declared, IEnumerable<Fact> real, TypeMatch match) =>
        from pair in declared.Zip(real)
        where pair.First.Value is { } value && !(value is ITypeSymbol type
            ? pair.Second.Value is ITypeSymbol other && match.Same(type, other)
            : value.Equals(pair.Second.Value))
        select Names.Differ(pair.First.What + pair.First.Shown, pair.Second.Shown);

    public static IEnumerable<Fact> OfMember(ISymbol member)
    {
        yield return new("", Access.Outside(member), Names.Of(member.DeclaredAccessibility));
        yield return Yes(member.IsStatic, "static", "an instance's");
        // Abstract members must be overridden; a member that is virtual here must be open to overriding there.
        if (member.ContainingType.TypeKind != TypeKind.Interface)
        {
            yield return Yes(member.IsAbstract, "abstract", "not abstract");
            yield return new("can be overridden", IsOpen(member) ? true : null, IsOpen(member) ? "" : "not");
        }
        var obsolete = ObsoleteError(member);
        yield return Yes(obsolete is null, "usable", $"[Obsolete] as an error ({obsolete})");
        var details = member switch
        {
            IMethodSymbol method => OfMethod(method),
            IPropertySymbol property => Returned(property.Type, property.RefKind)
                .Append(Accessor("get", property.GetMethod)).Append(Accessor("set", property.SetMethod)).Concat(OfParameters(property.Parameters)),
            IFieldSymbol field => [Typed("is of type ", field.Type), Storage(field)],
            IEventSymbol change => [Typed("is of type ", change.Type)],
            _ => [],
        };
        foreach (var detail in details) yield return detail;
    }

    public static IEnumerable<Fact> OfType(INamedTypeSymbol type)
    {
        yield return new("", Access.Outside(type), Names.Of(type.DeclaredAccessibility));
        yield return new("", type.TypeKind, $"a {Names.Of(type.TypeKind)}");
        var modifier = type.IsStatic ? "static" : type.IsAbstract ? "abstract" : type.IsSealed ? "sealed" : "open";
        yield return new("", type.TypeKind == TypeKind.Class ? modifier : null, modifier);
        yield return Yes(type.IsRefLikeType, "a ref struct", "no ref struct");
        var obsolete = ObsoleteError(type);
        yield return Yes(obsolete is null, "usable", $"[Obsolete] as an error ({obsolete})");
        foreach (var fact in OfTypeParameters(type.TypeParameters)) yield return fact;
        if (type.EnumUnderlyingType is { } values) yield return Typed("its values are ", values);
        foreach (var fact in type.DelegateInvokeMethod is { } call ? OfMethod(call) : []) yield return fact;
    }

    /// <summary>The parameters of a method, an indexer or a delegate.</summary>
    public static IEnumerable<Fact> OfParameters(IReadOnlyList<IParameterSymbol> parameters)
    {
        yield return new("has ", parameters.Count, parameters.Count == 1 ? "1 parameter" : $"{parameters.Count} parameters");
        foreach (var (parameter, at) in parameters.Select((parameter, at) => (parameter, at)))
        {
            var which = $"parameter {at + 1}, {parameter.Name}, is ";
            yield return Typed(which, parameter.Type);
            var passed = parameter.RefKind == RefKind.None ? "value" : $"{parameter.RefKind}".ToLowerInvariant();
            yield return new(which + "passed ", passed, "by " + passed);
            yield return new(which + "named ", parameter.Name, parameter.Name);
            yield return Yes(parameter.IsParams, "a params array", "a plain array") with { What = which };
            var value = parameter.HasExplicitDefaultValue ? "optional with " + Shown(parameter.ExplicitDefaultValue) : "required";
            yield return new(which, value, value);
        }
    }

    /// <summary>The message of [Obsolete] that makes a use an error; null where it makes none.</summary>
    private static string? ObsoleteError(ISymbol symbol) =>
        Obsolete(symbol) is { } mark && mark.ConstructorArguments.Any(argument => argument.Value is true)
            ? mark.ConstructorArguments[0].Value as string ?? ""
            : null;

    public static AttributeData? Obsolete(ISymbol symbol) =>
        symbol.GetAttributes().FirstOrDefault(one => one.AttributeClass?.ToDisplayString() == "System.ObsoleteAttribute");

    private static IEnumerable<Fact> OfMethod(IMethodSymbol method) => Returned(method.ReturnType, method.RefKind)
        .Append(Yes(method.IsExtensionMethod, "an extension", "no extension"))
        .Concat(OfTypeParameters(method.TypeParameters)).Concat(OfParameters(method.Parameters));

    private static IEnumerable<Fact> OfTypeParameters(IEnumerable<ITypeParameterSymbol> parameters)
    {
        foreach (var parameter in parameters)
        {
            var which = $"type parameter {parameter.Name} is ";
            yield return new(which, parameter.Variance,
                             parameter.Variance == VarianceKind.None ? "invariant" : $"{parameter.Variance}".ToLowerInvariant());
            var constraints = string.Join(", ", Constraints(parameter).DefaultIfEmpty("nothing"));
            yield return new(which + "constrained ", constraints, "to " + constraints);
        }
    }

    private static IEnumerable<string> Constraints(ITypeParameterSymbol parameter)
    {
        if (parameter.HasReferenceTypeConstraint) yield return "class";
        if (parameter.HasUnmanagedTypeConstraint) yield return "unmanaged";
        else if (parameter.HasValueTypeConstraint) yield return "struct";
        if (parameter.HasNotNullConstraint) yield return "notnull";
        if (parameter.HasConstructorConstraint) yield return "new()";
        foreach (var type in parameter.ConstraintTypes.Select(Names.Of).Order(StringComparer.Ordinal)) yield return type;
    }

    private static IEnumerable<Fact> Returned(ITypeSymbol type, RefKind by) =>
        [new("returns ", by, by switch { RefKind.None => "a value", RefKind.Ref => "a reference", _ => "a readonly reference" }),
         Typed("is of type ", type)];

    private static Fact Accessor(string word, IMethodSymbol? accessor)
    {
        if (accessor is null || !Access.IsReachable(accessor) || Declarations.IsOwn(accessor))
            return new($"{word} is ", null, accessor is null ? "missing" : Names.Of(accessor.DeclaredAccessibility));
        var obsolete = ObsoleteError(accessor);
        return new($"{word} is ", (Access.Outside(accessor), accessor.IsInitOnly, obsolete is null), Names.Of(accessor.DeclaredAccessibility) +
            (accessor.IsInitOnly ? " init" : "") + (obsolete is null ? "" : $", [Obsolete] as an error ({obsolete})"));
    }

    private static Fact Storage(IFieldSymbol field)
    {
        var value = field.ContainingType.TypeKind == TypeKind.Enum ? Convert.ToDecimal(field.ConstantValue) : field.ConstantValue;
        var shown = field.IsConst ? "const " + Shown(value) : field.IsReadOnly ? "readonly" : "writable";
        return new("", (field.IsConst, field.IsReadOnly, value), shown);
    }

    private static Fact Yes(bool value, string yes, string no) => new("", value, value ? yes : no);

    private static Fact Typed(string what, ITypeSymbol type) => new(what, type, Names.Of(type));

    private static bool IsOpen(ISymbol symbol) =>
        (symbol.IsVirtual || symbol.IsAbstract || symbol.IsOverride) && !symbol.IsSealed && !symbol.ContainingType.IsSealed;

    /// <summary>A constant as the messages write it.</summary>
    private static string Shown(object? value) => value switch
    {
        null => "null",
        string text => $"\"{text}\"",
        bool truth => truth ? "true" : "false",
        float number => number.ToString("R", CultureInfo.InvariantCulture) + "f",
        IFormattable number => number.ToString(null, CultureInfo.InvariantCulture),
        _ => value.ToString() ?? "",
    };
}
