namespace Penumbra.ApiCheck.Compare;

/// <summary>Writes symbols for messages, and finds which name is nearest to a misspelt one.</summary>
public static class Names
{
    private static readonly SymbolDisplayFormat Full = new(
        SymbolDisplayGlobalNamespaceStyle.Omitted,
        SymbolDisplayTypeQualificationStyle.NameAndContainingTypesAndNamespaces,
        SymbolDisplayGenericsOptions.IncludeTypeParameters,
        SymbolDisplayMemberOptions.IncludeParameters | SymbolDisplayMemberOptions.IncludeContainingType,
        parameterOptions: SymbolDisplayParameterOptions.IncludeType | SymbolDisplayParameterOptions.IncludeParamsRefOut,
        miscellaneousOptions: SymbolDisplayMiscellaneousOptions.UseSpecialTypes);

    private static readonly SymbolDisplayFormat Short = new(
        genericsOptions: SymbolDisplayGenericsOptions.IncludeTypeParameters,
        memberOptions: SymbolDisplayMemberOptions.IncludeParameters,
        parameterOptions: SymbolDisplayParameterOptions.IncludeType | SymbolDisplayParameterOptions.IncludeName |
                          SymbolDisplayParameterOptions.IncludeParamsRefOut,
        miscellaneousOptions: SymbolDisplayMiscellaneousOptions.UseSpecialTypes);

    public static string Of(ISymbol symbol) => symbol.ToDisplayString(Full);

    public static string ShortOf(ISymbol symbol) => symbol.ToDisplayString(Short);

    /// <summary>The sentence that tells every plain difference.</summary>
    public static string Differ(string here, string there) => $"{here} here, {there} in the real source";

    public static string Of(Accessibility accessibility) => accessibility switch
    {
        Accessibility.Public => "public",
        Accessibility.Protected => "protected",
        Accessibility.ProtectedOrInternal => "protected internal",
        Accessibility.ProtectedAndInternal => "private protected",
        Accessibility.Internal => "internal",
        _ => "private",
    };

    public static string Of(TypeKind kind) => kind == TypeKind.Struct ? "struct" : kind.ToString().ToLowerInvariant();

    /// <summary>The name with the fewest edits, where those are at most a third of its letters.</summary>
    public static T? Nearest<T>(string wanted, IEnumerable<T> candidates, Func<T, string> nameOf) where T : class =>
        candidates.Select(candidate => (candidate, edits: Edits(wanted, nameOf(candidate))))
            .Where(entry => entry.edits * 3 <= Math.Max(wanted.Length, 3)).OrderBy(entry => entry.edits)
            .Select(entry => entry.candidate).FirstOrDefault();

    private static int Edits(string left, string right)
    {
        var row = Enumerable.Range(0, right.Length + 1).ToArray();
        for (var i = 1; i <= left.Length; ++i)
        {
            var diagonal = row[0];
            row[0] = i;
            for (var j = 1; j <= right.Length; ++j)
            {
                var replaced = diagonal + (char.ToLowerInvariant(left[i - 1]) == char.ToLowerInvariant(right[j - 1]) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.Min(replaced, 1 + Math.Min(row[j], row[j - 1]));
            }
        }
        return row[^1];
    }
}
