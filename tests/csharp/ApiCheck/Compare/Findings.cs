using Microsoft.CodeAnalysis;
using Penumbra.ApiCheck.Package;
using Penumbra.ApiCheck.Report;

namespace Penumbra.ApiCheck.Compare;

/// <summary>
/// What the comparison found, over all symbol sets: the same difference under several sets is one difference, with
/// the sets' names. Only the sets in which the declaration itself is compiled count as the whole.
/// </summary>
public sealed class Findings
{
    private readonly Dictionary<Problem, HashSet<string>> problems = [];
    private readonly Dictionary<string, TypeResult> types = [];
    private SymbolSet set = SymbolSet.All[0];

    public IEnumerable<TypeResult> Types => types.Values.OrderBy(type => type.Name, StringComparer.Ordinal);

    public IEnumerable<string> Problems => problems
        .OrderBy(entry => entry.Key.Declaration?.File, StringComparer.Ordinal).ThenBy(entry => entry.Key.Declaration?.Line)
        .ThenBy(entry => entry.Key.Text, StringComparer.Ordinal).Select(Shown);

    public void Begin(SymbolSet next) => set = next;

    public TypeResult Type(string name, string source)
    {
        if (!types.TryGetValue(name, out var result))
            types[name] = result = new TypeResult(name, source);
        result.Sets.Add(set.Name);
        return result;
    }

    public void Add(Problem problem)
    {
        if (!problems.TryGetValue(problem, out var sets))
            problems[problem] = sets = [];
        sets.Add(set.Name);
    }

    public void Add(ISymbol declared, string text, ISymbol? real = null, IReadOnlyCollection<string>? preferred = null) =>
        Add(new Problem(Place.Of(declared), Names.Of(declared), text, Place.Of(real, preferred ?? [])));

    private string Shown(KeyValuePair<Problem, HashSet<string>> entry)
    {
        var among = types.Values.Where(type => entry.Key.Symbol.StartsWith(type.Name, StringComparison.Ordinal))
            .MaxBy(type => type.Name.Length)?.Sets ?? [.. SymbolSet.All.Select(one => one.Name)];
        return entry.Value.SetEquals(among) ? entry.Key.ToString() : $"{entry.Key} [only under: {string.Join(", ", entry.Value)}]";
    }
}

/// <summary>What was confirmed of one declared type.</summary>
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

    /// <summary>Obsolete in the real source, with a warning.</summary>
    public SortedSet<string> Obsolete { get; } = new(StringComparer.Ordinal);

    /// <summary>Compared with a type that the given sources do not hold, by its name alone.</summary>
    public SortedSet<string> ByName { get; } = new(StringComparer.Ordinal);
}
