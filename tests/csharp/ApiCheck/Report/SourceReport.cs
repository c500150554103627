using System.Security.Cryptography;
using System.Text;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;

namespace Penumbra.ApiCheck.Report;

/// <summary>
/// The committed answer of a check against sources: what was read, how much was compared, one record a type. A type's
/// fingerprint is of its declared signatures, so that a declaration changed since shows.
/// </summary>
public sealed record SourceReport
{
    public required string Generation { get; init; }
    public required IReadOnlyList<ReadSource> Sources { get; init; }
    public required IReadOnlyList<string> SymbolSets { get; init; }
    public required Totals Counts { get; init; }
    public required IReadOnlyList<CheckedType> Types { get; init; }
    public required IReadOnlyList<string> Problems { get; init; }

    public sealed record ReadSource(string Source, string Version, string VersionFrom, int Files);

    public sealed record Totals(int Types, int Declarations, int Inherited, int ByName, int Obsolete, int Differences);

    public sealed record CheckedType(string Name, string Source, IReadOnlyList<string> Files, int Declarations,
                                     string Fingerprint)
    {
        public IReadOnlyList<string>? Only { get; init; }
        public IReadOnlyList<string>? Inherited { get; init; }
        public IReadOnlyList<string>? ByName { get; init; }
        public IReadOnlyList<string>? Obsolete { get; init; }
    }

    private static readonly JsonSerializerOptions Form = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull,
        Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    public static SourceReport Of(string generation, SourceCheck check)
    {
        var types = check.Findings.Types.ToArray();
        var problems = check.Findings.Problems.ToArray();
        return new SourceReport
        {
            Generation = generation,
            Sources = [.. check.Sources.Select(source => new ReadSource(source.Folder.Source, source.Folder.Version,
                                                                        source.Folder.VersionFrom, source.Files))],
            SymbolSets = [.. SymbolSet.All.Select(set => set.Name)],
            Counts = new Totals(types.Length, types.Sum(type => type.Members.Count), types.Sum(type => type.Inherited.Count),
                                types.Sum(type => type.ByName.Count), types.Sum(type => type.Obsolete.Count), problems.Length),
            Types = [.. types.Select(Record)],
            Problems = problems,
        };
    }

    public static SourceReport Read(string file) => JsonSerializer.Deserialize<SourceReport>(File.ReadAllText(file), Form)!;

    /// <summary>JSON with a record to a line, so that a difference between two files shows which changed.</summary>
    public string Json()
    {
        var fields = JsonSerializer.SerializeToNode(this, Form)!.AsObject().Select(
            field => $"\"{field.Key}\":{Lines(field.Value!)}");
        return "{" + string.Join(",\n", fields) + "}\n";
    }

    private static string Lines(JsonNode value) =>
        value is JsonArray { Count: > 0 } records
            ? "[\n" + string.Join(",\n", records.Select(record => record!.ToJsonString(Form))) + "]"
            : value.ToJsonString(Form);

    /// <summary>Sixteen hexadecimal digits of SHA-256.</summary>
    public static string Fingerprint(IEnumerable<string> members)
    {
        var hash = SHA256.HashData(Encoding.UTF8.GetBytes(string.Join('\n', members.Distinct().Order(StringComparer.Ordinal))));
        return Convert.ToHexStringLower(hash)[..16];
    }

    private static CheckedType Record(TypeResult type)
    {
        var sets = SymbolSet.All.Select(set => set.Name).Where(type.Sets.Contains).ToArray();
        return new CheckedType(type.Name, type.Source, [.. type.Files], type.Members.Count, Fingerprint(type.Members))
        {
            Only = sets.Length == SymbolSet.All.Count ? null : sets, Inherited = NullIfEmpty(type.Inherited),
            ByName = NullIfEmpty(type.ByName), Obsolete = NullIfEmpty(type.Obsolete),
        };
    }

    private static string[]? NullIfEmpty(IReadOnlyCollection<string> names) => names.Count == 0 ? null : [.. names];
}
