namespace Penumbra.ApiCheck.Report;

/// <summary>A place in a file, line and column counted from one.</summary>
public sealed record Place(string File, int Line, int Column)
{
    public static Place? Of(Location? location) => location is { IsInSource: true } && location.GetLineSpan() is var span
        ? new Place(span.Path, span.StartLinePosition.Line + 1, span.StartLinePosition.Character + 1)
        : null;

    /// <summary>The place of the symbol. Of the parts of a partial type it is the longest, which says most.</summary>
    public static Place? Of(ISymbol? symbol)
    {
        var longest = symbol?.DeclaringSyntaxReferences.MaxBy(part => part.Span.Length)?.SyntaxTree;
        return Of(symbol?.Locations.FirstOrDefault(location => location.IsInSource && location.SourceTree == longest));
    }

    public override string ToString() => $"{File}:{Line}:{Column}";
}

/// <summary>
/// One difference: the declared type or the assembly that it belongs to, the declaration's place, the symbol, what is
/// wrong and where the real one stands.
/// </summary>
public sealed record Problem(string Owner, Place? Declaration, string Symbol, string Text, Place? Real)
{
    public override string ToString()
    {
        var place = Declaration is null ? "" : Declaration + ": ";
        var real = Real is null ? "" : $" (see {Real.File}:{Real.Line})";
        return $"{place}{Symbol}: {Text}{real}";
    }
}
