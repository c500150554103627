namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// Accessibility as another assembly sees it: internal is out of reach, protected internal is protected.
/// </summary>
public static class Access
{
    public static Accessibility Outside(ISymbol symbol) => symbol.DeclaredAccessibility switch
    {
        Accessibility.ProtectedOrInternal => Accessibility.Protected,
        Accessibility.Public or Accessibility.Protected => symbol.DeclaredAccessibility,
        _ => Accessibility.Private,
    };

    public static bool IsReachable(ISymbol symbol) => Outside(symbol) != Accessibility.Private;
}
