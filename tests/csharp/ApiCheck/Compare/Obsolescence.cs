namespace Penumbra.ApiCheck.Compare;

/// <summary>[Obsolete] of the real source: as an error the member cannot be called, as a warning it is noted.</summary>
public static class Obsolescence
{
    public sealed record Mark(bool IsError, string Message);

    public static Mark? Of(ISymbol real)
    {
        var mark = real.GetAttributes().FirstOrDefault(one => one.AttributeClass?.ToDisplayString() == "System.ObsoleteAttribute");
        if (mark is null) return null;
        var arguments = mark.ConstructorArguments.Select(argument => argument.Value).ToArray();
        return new Mark(arguments.OfType<bool>().FirstOrDefault(), arguments.OfType<string>().FirstOrDefault() ?? "");
    }
}
