namespace Penumbra.Tests;

public class ShadowUniformsTests
{
    private static readonly AtlasLayout Layout = new AtlasLayout(2048, 3);

    private static JsonElement ValuesOf(string technique)
    {
        var file = Path.Combine(TestContext.CurrentContext.TestDirectory, "techniques.json");
        return JsonDocument.Parse(File.ReadAllText(file)).RootElement.GetProperty("techniques").EnumerateArray()
            .Single(entry => entry.GetProperty("name").GetString() == technique).GetProperty("values");
    }

    [TestCase("pcss-angular-24-16", false)]
    [TestCase("pcss-angular-24-16-hdrp", true)]
    public void DefaultsAreTheTechniqueLists(string technique, bool hdrp)
    {
        var values = ValuesOf(technique);
        var parameters = hdrp ? SoftShadowParameters.HdrpDefault : SoftShadowParameters.Default;
        var ours = new Dictionary<string, float>
        {
            ["blockerSamples"] = parameters.BlockerSamples, ["filterSamples"] = parameters.FilterSamples,
            ["blockerClump"] = parameters.BlockerClump, ["minFilterTexels"] = parameters.MinFilterTexels,
            ["maxPenumbraMetres"] = parameters.MaxPenumbraMetres, ["maxSamplingMetres"] = parameters.MaxSamplingMetres,
        };
        foreach (var (name, value) in ours)
        {
            Assert.That(value, Is.EqualTo(values.GetProperty(name).GetSingle()), name);
        }
    }

    [Test]
    public void HdrpsAnglesAreTheTechniqueLists()
    {
        var values = ValuesOf("pcss-angular-24-16-hdrp");
        var hdrp = new ShadowUniforms(SoftShadowParameters.HdrpDefault, Layout, 0).PcssHdrp;
        Assert.That(hdrp.searchTanHalf, Is.EqualTo(values.GetProperty("searchTanHalf").GetSingle()).Within(1e-8));
        Assert.That(hdrp.minFilterTanHalf, Is.EqualTo(values.GetProperty("minFilterTanHalf").GetSingle()).Within(1e-8));
    }

    [Test]
    public void EachNumberIsWhereTheShaderReadsIt()
    {
        var parameters = new SoftShadowParameters
        {
            AngularDiameterDegrees = 2.0f, BlockerSamples = 11, FilterSamples = 12, BlockerClump = 1.5f,
            MinFilterTexels = 1.75f, MaxPenumbraMetres = 21.0f, MaxSamplingMetres = 22.0f,
            SearchRadiusMetres = 23.0f, HdrpSearchDegrees = 5.0f, HdrpMinFilterDegrees = 7.0f, CascadeBorder = 0.125f,
        };
        var uniforms = new ShadowUniforms(parameters, Layout, 9);
        Assert.That(uniforms.MainLightAtlasTexelSize, Is.EqualTo(Layout.TexelSize));
        Assert.That(uniforms.MainLightParams, Is.EqualTo(new Vector4(3, AngularDiameter.TanHalf(2.0f), 9, 0.125f)));
        Assert.That(new[] { uniforms.PcssAngular.Vector0, uniforms.PcssAngular.Vector1 },
                    Is.EqualTo(new[] { new Vector4(11, 12, 1.5f, 1.75f), new Vector4(21, 22, 0, 0) }));
        Assert.That(new[] { uniforms.PcssHdrp.Vector0, uniforms.PcssHdrp.Vector1 },
                    Is.EqualTo(new[]
                    {
                        new Vector4(11, 12, 1.5f, 1.75f),
                        new Vector4(21, 22, AngularDiameter.TanHalf(5.0f), AngularDiameter.TanHalf(7.0f)),
                    }));
        parameters.BlockerSamples = 32;
        uniforms = new ShadowUniforms(parameters, Layout, 9);
        Assert.That(new[] { uniforms.PcssClassic.Vector0 }, Is.EqualTo(new[] { new Vector4(32, 23, 1.75f, 0) }));
    }

    // The shaders take the index modulo 64; a float would lose its last bits after some days.
    [TestCase(0, 0)]
    [TestCase(63, 63)]
    [TestCase(64, 0)]
    [TestCase(1 << 30, 0)]
    [TestCase(int.MaxValue, 63)]
    [TestCase(-1, 63)]
    public void TheFrameIndexRepeatsAsTheNoiseDoes(int frame, int expected) =>
        Assert.That(new ShadowUniforms(SoftShadowParameters.Default, Layout, frame).MainLightParams.z,
                    Is.EqualTo(expected));

    [Test]
    public void WhateverTheParametersEveryComponentIsFiniteAndInRange()
    {
        var random = new Random(3);
        float Any() => Adversary.Floats[random.Next(Adversary.Floats.Length)];
        int Count() => Adversary.Ints[random.Next(Adversary.Ints.Length)];
        for (var i = 0; i < 5000; ++i)
        {
            var parameters = new SoftShadowParameters
            {
                AngularDiameterDegrees = Any(), BlockerSamples = Count(), FilterSamples = Count(),
                BlockerClump = Any(), MinFilterTexels = Any(), MaxPenumbraMetres = Any(),
                MaxSamplingMetres = Any(), SearchRadiusMetres = Any(), HdrpSearchDegrees = Any(),
                HdrpMinFilterDegrees = Any(), CascadeBorder = Any(),
            };
            var uniforms = new ShadowUniforms(parameters, Layout, Count());
            AssertWithin(uniforms.MainLightParams, new Vector4(3, 0.26795f, 63, 1));
            AssertWithin(new[] { uniforms.PcssAngular.Vector0, uniforms.PcssAngular.Vector1 },
                         new Vector4(128, 128, 8, 64), new Vector4(1e6f, 1e6f, 0, 0));
            AssertWithin(new[] { uniforms.PcssClassic.Vector0 }, new Vector4(128, 1e6f, 64, 0));
            AssertWithin(new[] { uniforms.PcssHdrp.Vector0, uniforms.PcssHdrp.Vector1 },
                         new Vector4(64, 64, 8, 64), new Vector4(1e6f, 1e6f, 1000, 1000));
        }
    }

    private static void AssertWithin(Vector4[] vectors, params Vector4[] largest)
    {
        for (var i = 0; i < vectors.Length; ++i) AssertWithin(vectors[i], largest[i]);
    }

    private static void AssertWithin(Vector4 v, Vector4 largest) =>
        Assert.That(v.x >= 0 && v.x <= largest.x && v.y >= 0 && v.y <= largest.y && v.z >= 0 &&
                    v.z <= largest.z && v.w >= 0 && v.w <= largest.w, $"{v} beyond {largest}");
}
