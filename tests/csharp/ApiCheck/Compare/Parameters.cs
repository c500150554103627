using System.Globalization;

namespace Penumbra.ApiCheck.Compare;

/// <summary>The parameters of two methods, indexers or delegates that are paired with each other.</summary>
public static class Parameters
{
    /// <summary>The differences, one sentence each; types and passing modes included.</summary>
    public static IEnumerable<string> Differences(IReadOnlyList<IParameterSymbol> declared,
                                                  IReadOnlyList<IParameterSymbol> real, TypeMatch match)
    {
        if (declared.Count != real.Count)
        {
            yield return Names.Differ($"has {Count(declared.Count)}", Count(real.Count));
            yield break;
        }
        for (var at = 0; at < declared.Count; ++at)
        {
            var (one, other) = (declared[at], real[at]);
            var which = $"parameter {at + 1}, {one.Name},";
            if (!match.Same(one.Type, other.Type))
                yield return Names.Differ($"{which} is {Names.Of(one.Type)}", Names.Of(other.Type));
            if (one.RefKind != other.RefKind)
                yield return Names.Differ($"{which} is passed {Passed(one.RefKind)}", Passed(other.RefKind));
            if (one.Name != other.Name) yield return $"{which} is named {other.Name} in the real source";
            if (one.IsParams != other.IsParams) yield return Names.Differ($"{which} is {Role(one)}", Role(other));
            if (Default(one) != Default(other)) yield return Names.Differ($"{which} is {Default(one)}", Default(other));
        }
    }

    /// <summary>A constant as the messages write it.</summary>
    public static string Value(object? value) => value switch
    {
        null => "null",
        string text => $"\"{text}\"",
        bool truth => truth ? "true" : "false",
        float number => number.ToString("R", CultureInfo.InvariantCulture) + "f",
        IFormattable number => number.ToString(null, CultureInfo.InvariantCulture),
        _ => value.ToString() ?? "",
    };

    private static string Default(IParameterSymbol parameter) =>
        parameter.HasExplicitDefaultValue ? "optional with " + Value(parameter.ExplicitDefaultValue) : "required";

    private static string Role(IParameterSymbol parameter) => parameter.IsParams ? "a params array" : "a plain array";

    private static string Passed(RefKind kind) => kind switch
    {
        RefKind.None => "by value",
        RefKind.Ref => "by ref",
        RefKind.Out => "by out",
        RefKind.In => "by in",
        _ => "by ref readonly",
    };

    private static string Count(int count) => count == 1 ? "1 parameter" : $"{count} parameters";
}
