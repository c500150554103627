namespace Penumbra.Tests;

/// <summary>The techniques as the study measures them, and their structs: tests/golden/techniques.json.</summary>
internal static class Measured
{
    internal static readonly JsonElement List =
        JsonDocument.Parse(File.ReadAllText(Path.Combine(FakeShader.PackageRoot(), "tests", "golden", "techniques.json")))
            .RootElement;

    /// <summary>The entry with that name, of `techniques` or `structs`.</summary>
    internal static JsonElement Named(string list, string name) =>
        List.GetProperty(list).EnumerateArray().Single(entry => entry.GetProperty("name").GetString() == name);
}
