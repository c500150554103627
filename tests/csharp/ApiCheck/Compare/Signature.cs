namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// Writes a declaration as one line: all that is compared with the real source, and nothing of the bodies.
/// </summary>
public static class Signature
{
    private static readonly SymbolDisplayFormat Everything = new(
        SymbolDisplayGlobalNamespaceStyle.Omitted,
        SymbolDisplayTypeQualificationStyle.NameAndContainingTypesAndNamespaces,
        SymbolDisplayGenericsOptions.IncludeTypeParameters | SymbolDisplayGenericsOptions.IncludeTypeConstraints |
            SymbolDisplayGenericsOptions.IncludeVariance,
        SymbolDisplayMemberOptions.IncludeParameters | SymbolDisplayMemberOptions.IncludeContainingType |
            SymbolDisplayMemberOptions.IncludeType | SymbolDisplayMemberOptions.IncludeModifiers |
            SymbolDisplayMemberOptions.IncludeAccessibility | SymbolDisplayMemberOptions.IncludeConstantValue |
            SymbolDisplayMemberOptions.IncludeRef,
        SymbolDisplayDelegateStyle.NameAndSignature,
        parameterOptions: SymbolDisplayParameterOptions.IncludeType | SymbolDisplayParameterOptions.IncludeName |
            SymbolDisplayParameterOptions.IncludeParamsRefOut | SymbolDisplayParameterOptions.IncludeDefaultValue |
            SymbolDisplayParameterOptions.IncludeExtensionThis,
        propertyStyle: SymbolDisplayPropertyStyle.ShowReadWriteDescriptor,
        kindOptions: SymbolDisplayKindOptions.IncludeTypeKeyword,
        miscellaneousOptions: SymbolDisplayMiscellaneousOptions.UseSpecialTypes);

    /// <summary>The signatures of all that is compared of a declared type, nested types included.</summary>
    public static IEnumerable<string> AllOf(INamedTypeSymbol declared) => declared.GetMembers().Where(IsCompared)
        .SelectMany(member => member is INamedTypeSymbol nested ? AllOf(nested) : [Of(member)]).Prepend(Of(declared));

    /// <summary>Whether the member is compared: the package can reach it and Unity has it.</summary>
    public static bool IsCompared(ISymbol member) =>
        !member.IsImplicitlyDeclared && Access.IsReachable(member) && !Declarations.IsOwn(member) &&
        member is not IMethodSymbol { AssociatedSymbol: not null };

    private static string Of(ISymbol symbol)
    {
        var text = symbol.ToDisplayString(Everything);
        if (symbol is not INamedTypeSymbol type) return text;
        var above = new[] { type.BaseType }.Concat(type.Interfaces).OfType<INamedTypeSymbol>()
            .Where(other => other.SpecialType is not SpecialType.System_Object and not SpecialType.System_ValueType
                and not SpecialType.System_Enum)
            .Select(Names.Of);
        return $"{Names.Of(type.DeclaredAccessibility)} {text} : {string.Join(", ", above)}" +
               (type.IsSealed ? " sealed" : "") + (type.IsAbstract ? " abstract" : "") + (type.IsStatic ? " static" : "");
    }
}
