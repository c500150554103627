namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// The findings of the comparison, over all symbol sets: the same difference under several sets is one difference, and
/// the sets are named where they are not all those under which its owner, a declared type or an assembly, was looked
/// at.
/// </summary>
public sealed class Findings
{
    private readonly Dictionary<Problem, List<string>> problems = [];
    private readonly Dictionary<string, HashSet<string>> looks = [];
    private readonly Dictionary<string, TypeResult> types = [];
    private SymbolSet set = SymbolSet.All[0];

    public IEnumerable<TypeResult> Types => types.Values.OrderBy(type => type.Name, StringComparer.Ordinal);

    public IEnumerable<string> Problems => problems
        .OrderBy(entry => entry.Key.Declaration?.File, StringComparer.Ordinal).ThenBy(entry => entry.Key.Declaration?.Line)
        .ThenBy(entry => entry.Key.Text, StringComparer.Ordinal)
        .Select(entry => entry.Value.Count == looks[entry.Key.Owner].Count
            ? entry.Key.ToString()
            : $"{entry.Key} [only under: {string.Join(", ", entry.Value)}]");

    public void Begin(SymbolSet next) => set = next;

    /// <summary>Records that the owner is looked at under the present set.</summary>
    public void Look(string owner)
    {
        looks.TryAdd(owner, []);
        looks[owner].Add(set.Name);
    }

    public TypeResult Type(INamedTypeSymbol declared, string source)
    {
        var name = Names.Of(declared);
        types.TryAdd(name, new TypeResult(name, source));
        types[name].Sets.Add(set.Name);
        return types[name];
    }

    public void Add(Problem problem)
    {
        problems.TryAdd(problem, []);
        if (!problems[problem].Contains(set.Name)) problems[problem].Add(set.Name);
    }

    /// <summary>Adds a problem of a declared symbol, whose outermost type owns the problem.</summary>
    public void Add(ISymbol declared, string text, ISymbol? real = null)
    {
        var owner = declared;
        while (owner.ContainingType is { } outer) owner = outer;
        Add(new Problem(Names.Of(owner), Place.Of(declared), Names.Of(declared), text, Place.Of(real)));
    }
}

/// <summary>The members that were confirmed of one declared type.</summary>
public sealed class TypeResult(string name, string source)
{
    public string Name { get; } = name;
    public string Source { get; } = source;
    public SortedSet<string> Files { get; } = new(StringComparer.Ordinal);

    public HashSet<string> Sets { get; } = [];

    /// <summary>Every member that was compared, as it was declared: the type's fingerprint is made of them.</summary>
    public SortedSet<string> Members { get; } = new(StringComparer.Ordinal);

    /// <summary>Members that the real type has from a base type that we leave out.</summary>
    public SortedSet<string> Inherited { get; } = new(StringComparer.Ordinal);

    /// <summary>Members that are obsolete in the real source, with a warning.</summary>
    public SortedSet<string> Obsolete { get; } = new(StringComparer.Ordinal);

    /// <summary>Members that were compared, by name alone, with a type that the given sources do not hold.</summary>
    public SortedSet<string> ByName { get; } = new(StringComparer.Ordinal);
}
