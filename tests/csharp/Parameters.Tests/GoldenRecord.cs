namespace Penumbra.Tests;

/// <summary>
/// One set of inputs and answers of tests/golden/parameters.json, which tests/parameters compares with the C++.
/// </summary>
internal sealed class GoldenRecord
{
    private readonly JsonElement json;

    private GoldenRecord(string label, JsonElement json) => (Label, this.json) = (label, json);

    /// <summary>The place of the record, such as "cascades[3] far from the origin".</summary>
    public string Label { get; }

    public static IEnumerable<GoldenRecord> Of(string section)
    {
        var file = Path.Combine(TestContext.CurrentContext.TestDirectory, "parameters.json");
        var index = 0;
        foreach (var record in JsonDocument.Parse(File.ReadAllText(file)).RootElement.GetProperty(section)
                     .EnumerateArray())
        {
            var name = record.TryGetProperty("name", out var given) ? given.GetString() : "";
            yield return new GoldenRecord($"{section}[{index++}] {name}", record);
        }
    }

    public float Float(string key) => json.GetProperty(key).GetSingle();
    public int Int(string key) => json.GetProperty(key).GetInt32();
    public bool Bool(string key) => json.GetProperty(key).GetBoolean();
    public string Text(string key) => json.GetProperty(key).GetString();
    public Vector4 Vector(string key) => ToVector(json.GetProperty(key));
    public int Length(string key) => json.GetProperty(key).GetArrayLength();
    public Vector4 Vector(string key, int index) => ToVector(json.GetProperty(key)[index]);

    /// <summary>The matrix of the key; the file has it row-major.</summary>
    public Matrix4x4 Matrix(string key)
    {
        var n = json.GetProperty(key);
        Vector4 Column(int c) => new Vector4(n[c].GetSingle(), n[4 + c].GetSingle(), n[8 + c].GetSingle(),
                                             n[12 + c].GetSingle());
        return new Matrix4x4(Column(0), Column(1), Column(2), Column(3));
    }

    public SoftShadowParameters Parameters => new SoftShadowParameters
    {
        AngularDiameterDegrees = Float("degrees"), BlockerSamples = Int("blocker_samples"),
        FilterSamples = Int("filter_samples"), BlockerClump = Float("blocker_clump"),
        MinFilterTexels = Float("min_filter_texels"), MaxPenumbraMetres = Float("max_penumbra_metres"),
        MaxSamplingMetres = Float("max_sampling_metres"), SearchRadiusMetres = Float("search_radius_metres"),
        HdrpSearchDegrees = Float("hdrp_search_degrees"), HdrpMinFilterDegrees = Float("hdrp_min_filter_degrees"),
    };

    public AtlasLayout Layout => new AtlasLayout(Int("resolution"), Int("cascades"));

    public SoftShadowKernel Kernel
    {
        get
        {
            switch (Text("soft_quality"))
            {
                case "off": return SoftShadowKernel.Off;
                case "low": return SoftShadowKernel.Low;
                case "medium": return SoftShadowKernel.Medium;
                case "high": return SoftShadowKernel.High;
                default: throw new InvalidDataException($"{Label}: soft_quality {Text("soft_quality")}");
            }
        }
    }

    private static Vector4 ToVector(JsonElement n) =>
        new Vector4(n[0].GetSingle(), n[1].GetSingle(), n[2].GetSingle(), n[3].GetSingle());
}
