namespace Penumbra.Tests;

/// <summary>
/// Rules for cascades tell filters the values that their programs are measured with: tests/golden/cascade_rules.json,
/// which tests/techniques/cascade_rules_test.cpp holds against the manifests' packing.
/// </summary>
public sealed class CascadeVectorTests
{
    private static JsonElement Golden() =>
        JsonDocument.Parse(File.ReadAllText(Path.Combine(TestContext.CurrentContext.TestDirectory,
                                                         "cascade_rules.json"))).RootElement;

    private static Vector4 Vector(JsonElement value)
    {
        float[] numbers = value.EnumerateArray().Select(number => (float)number.GetDouble()).ToArray();
        return new Vector4(numbers[0], numbers[1], numbers[2], numbers[3]);
    }

    private static CascadeVector Made(JsonElement one)
    {
        string from = one.GetProperty("base").GetString();
        Vector4 value = Vector(one.GetProperty("value"));
        return new CascadeVector(one.GetProperty("uniform").GetString(), from == "" ? null : from,
                                 one.GetProperty("own").GetInt32(), value.x, value.y, value.z, value.w);
    }

    private static ShadowUniforms Frame(JsonElement fields)
    {
        float Number(string name) => (float)fields.GetProperty(name).GetDouble();
        var parameters = new SoftShadowParameters
        {
            BlockerSamples = (int)Number("blockerSamples"), FilterSamples = (int)Number("filterSamples"),
            BlockerClump = Number("blockerClump"), MinFilterTexels = Number("minFilterTexels"),
            MaxPenumbraMetres = Number("maxPenumbraMetres"), MaxSamplingMetres = Number("maxSamplingMetres"),
        };
        return new ShadowUniforms(parameters, new AtlasLayout(2048, 4), 0);
    }

    [Test]
    public void RulesAreToldAsTheyAreMeasured()
    {
        JsonElement golden = Golden();
        ShadowUniforms frame = Frame(golden.GetProperty("frame"));
        JsonElement[] cases = golden.GetProperty("cases").EnumerateArray().ToArray();
        Assert.That(cases.Length, Is.GreaterThanOrEqualTo(4));
        foreach (JsonElement one in cases)
        {
            CascadeVector vector = Made(one);
            Assert.That(vector.Uniform, Is.EqualTo(Shader.PropertyToID(one.GetProperty("uniform").GetString())));
            Assert.That(vector.In(frame), Is.EqualTo(Vector(one.GetProperty("expected"))), one.ToString());
        }
    }

    [Test]
    public void WhatAFrameDoesNotHaveIsAsItIsListed()
    {
        var vector = new CascadeVector("_PenumbraOtherParameters0From1", "_PenumbraOtherParameters0", 2, 1.0f, 2.0f,
                                       3.0f, 4.0f);
        Assert.That(vector.In(Frame(Golden().GetProperty("frame"))), Is.EqualTo(new Vector4(1.0f, 2.0f, 3.0f, 4.0f)));
    }

    [Test]
    public void EveryUniformOfAFilterIsFound()
    {
        ShadowUniforms frame = Frame(Golden().GetProperty("frame"));
        foreach ((int uniform, Vector4 held) in new[]
                 {
                     (PcssAngularParameters.Uniform0, frame.PcssAngular.Vector0),
                     (PcssAngularParameters.Uniform1, frame.PcssAngular.Vector1),
                     (PcssClassicParameters.Uniform0, frame.PcssClassic.Vector0),
                     (PcssHdrpParameters.Uniform0, frame.PcssHdrp.Vector0),
                     (PcssHdrpParameters.Uniform1, frame.PcssHdrp.Vector1),
                 })
        {
            Assert.That(frame.TryGet(uniform, out Vector4 found));
            Assert.That(found, Is.EqualTo(held));
        }
        Assert.That(frame.TryGet(MaskParameters.Uniform0, out Vector4 _), Is.False);
    }
}
