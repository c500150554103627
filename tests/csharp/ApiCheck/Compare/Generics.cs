namespace Penumbra.ApiCheck.Compare;

/// <summary>Type parameters with their constraints and variance.</summary>
public static class Generics
{
    /// <summary>The differences, one sentence each.</summary>
    public static IEnumerable<string> Differences(IReadOnlyList<ITypeParameterSymbol> declared,
                                                  IReadOnlyList<ITypeParameterSymbol> real, TypeMatch match)
    {
        foreach (var (one, other) in declared.Zip(real))
        {
            if (one.Variance != other.Variance)
                yield return Names.Differ($"type parameter {one.Name} is {Word(one.Variance)}", Word(other.Variance));
            if (!Same(one, other, match))
                yield return Names.Differ($"type parameter {one.Name} is constrained to {Constraints(one)}", $"to {Constraints(other)}");
        }
    }

    private static bool Same(ITypeParameterSymbol declared, ITypeParameterSymbol real, TypeMatch match) =>
        Flags(declared).SequenceEqual(Flags(real)) &&
        declared.ConstraintTypes.Length == real.ConstraintTypes.Length &&
        declared.ConstraintTypes.All(type => real.ConstraintTypes.Any(other => match.Same(type, other)));

    private static string Constraints(ITypeParameterSymbol parameter)
    {
        var words = Flags(parameter).Concat(parameter.ConstraintTypes.Select(Names.Of)).ToArray();
        return words.Length == 0 ? "nothing" : string.Join(", ", words);
    }

    private static IEnumerable<string> Flags(ITypeParameterSymbol parameter)
    {
        if (parameter.HasReferenceTypeConstraint) yield return "class";
        if (parameter.HasUnmanagedTypeConstraint) yield return "unmanaged";
        else if (parameter.HasValueTypeConstraint) yield return "struct";
        if (parameter.HasNotNullConstraint) yield return "notnull";
        if (parameter.HasConstructorConstraint) yield return "new()";
    }

    private static string Word(VarianceKind variance) => variance switch
    {
        VarianceKind.In => "in",
        VarianceKind.Out => "out",
        _ => "invariant",
    };
}
