using Microsoft.CodeAnalysis;
using Penumbra.ApiCheck.Sources;

namespace Penumbra.ApiCheck.Compare;

/// <summary>What two members of the same kind and signature differ in: one sentence a difference.</summary>
public sealed class MemberComparison(TypeMatch match)
{
    public IEnumerable<string> Differences(ISymbol declared, ISymbol real)
    {
        if (Access.Outside(declared) != Access.Outside(real))
            yield return $"{Names.Of(declared.DeclaredAccessibility)} here, {Names.Of(real.DeclaredAccessibility)} in the real source";
        if (declared.IsStatic != real.IsStatic)
            yield return $"{Static(declared)} here, {Static(real)} in the real source";
        if (Overriding(declared, real) is { } overriding)
            yield return overriding;
        var details = (declared, real) switch
        {
            (IMethodSymbol one, IMethodSymbol other) => Methods(one, other),
            (IPropertySymbol one, IPropertySymbol other) => Properties(one, other),
            (IFieldSymbol one, IFieldSymbol other) => Fields(one, other),
            (IEventSymbol one, IEventSymbol other) => Typed("the event", one.Type, other.Type),
            _ => [],
        };
        foreach (var detail in details)
            yield return detail;
        if (Obsolescence.Of(real) is { IsError: true } mark)
            yield return $"[Obsolete] as an error in the real source: {mark.Message}";
    }

    public IEnumerable<string> Methods(IMethodSymbol declared, IMethodSymbol real) =>
        Returned(declared.ReturnType, declared.RefKind, real.ReturnType, real.RefKind)
            .Concat(Parameters.Differences(declared.Parameters, real.Parameters, match))
            .Concat(declared.IsExtensionMethod == real.IsExtensionMethod
                ? []
                : [$"{Extension(declared)} here, {Extension(real)} in the real source"])
            .Concat(Generics.Differences(declared.TypeParameters, real.TypeParameters, match));

    private IEnumerable<string> Properties(IPropertySymbol declared, IPropertySymbol real) =>
        Returned(declared.Type, declared.RefKind, real.Type, real.RefKind)
            .Concat(Parameters.Differences(declared.Parameters, real.Parameters, match))
            .Concat(Accessor("get", declared.GetMethod, real.GetMethod))
            .Concat(Accessor("set", declared.SetMethod, real.SetMethod));

    private static IEnumerable<string> Accessor(string word, IMethodSymbol? declared, IMethodSymbol? real)
    {
        if (declared is null || !Access.IsReachable(declared) || Declarations.IsOwn(declared))
            yield break;
        if (real is null)
            yield return $"has {word} here, none in the real source";
        else if (Access.Outside(declared) != Access.Outside(real))
            yield return $"{word} is {Names.Of(declared.DeclaredAccessibility)} here, {Names.Of(real.DeclaredAccessibility)} in the real source";
        else if (declared.IsInitOnly != real.IsInitOnly)
            yield return $"{(declared.IsInitOnly ? "init" : "set")} here, {(real.IsInitOnly ? "init" : "set")} in the real source";
        if (real is not null && Obsolescence.Of(real) is { IsError: true } mark)
            yield return $"{word} is [Obsolete] as an error in the real source: {mark.Message}";
    }

    private IEnumerable<string> Fields(IFieldSymbol declared, IFieldSymbol real)
    {
        if (declared.ContainingType.TypeKind == TypeKind.Enum)
        {
            if (!Equals(Convert.ToDecimal(declared.ConstantValue), Convert.ToDecimal(real.ConstantValue)))
                yield return $"is {Parameters.Value(declared.ConstantValue)} here, {Parameters.Value(real.ConstantValue)} in the real source";
            yield break;
        }
        foreach (var difference in Typed("the field", declared.Type, real.Type))
            yield return difference;
        if (declared.IsConst != real.IsConst || declared.IsReadOnly != real.IsReadOnly)
            yield return $"{Storage(declared)} here, {Storage(real)} in the real source";
        else if (declared.IsConst && !Equals(declared.ConstantValue, real.ConstantValue))
            yield return $"is {Parameters.Value(declared.ConstantValue)} here, {Parameters.Value(real.ConstantValue)} in the real source";
    }

    private IEnumerable<string> Returned(ITypeSymbol declared, RefKind declaredBy, ITypeSymbol real, RefKind realBy)
    {
        if (declaredBy != realBy)
            yield return $"returns {By(declaredBy)} here, {By(realBy)} in the real source";
        if (!match.Same(declared, real))
            yield return $"is of type {Names.Of(declared)} here, {Names.Of(real)} in the real source";
    }

    private IEnumerable<string> Typed(string what, ITypeSymbol declared, ITypeSymbol real)
    {
        if (!match.Same(declared, real))
            yield return $"{what} is of type {Names.Of(declared)} here, {Names.Of(real)} in the real source";
    }

    /// <summary>What is abstract must be overridden; what is virtual here must be open to it there.</summary>
    private static string? Overriding(ISymbol declared, ISymbol real)
    {
        if (declared.ContainingType.TypeKind == TypeKind.Interface)
            return null;
        if (declared.IsAbstract != real.IsAbstract)
            return $"{(declared.IsAbstract ? "abstract" : "not abstract")} here, {(real.IsAbstract ? "abstract" : "not abstract")} in the real source";
        return IsOpen(declared) && !IsOpen(real) ? "can be overridden here, not in the real source" : null;
    }

    private static bool IsOpen(ISymbol symbol) =>
        (symbol.IsVirtual || symbol.IsAbstract || symbol.IsOverride) && !symbol.IsSealed && !symbol.ContainingType.IsSealed;

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
