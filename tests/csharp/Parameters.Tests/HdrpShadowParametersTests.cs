namespace Penumbra.Tests;

/// <summary>Lights and maps without scales; tests/golden/parameters.json has the others.</summary>
public class HdrpShadowParametersTests
{
    [Test]
    public void APointLightHasNoInverseAndTheWholeRangeOfBlockers()
    {
        var hdrp = new HdrpShadowParameters(new LightFrustum().Scales(0.0f), SoftShadowParameters.HdrpDefault);
        Assert.That(hdrp.Params0.x, Is.Zero);
        Assert.That(hdrp.Params0.y, Is.Zero);
        Assert.That(hdrp.Params0.z / LightFrustum.Range, Is.EqualTo(1.0).Within(1e-6));
    }

    [Test]
    public void UrpsEntriesBeyondTheCountHaveNoScales([Values] bool reversedZ)
    {
        var scales = new CascadeScales(LightFrustum.NoOp(reversedZ), new AtlasLayout(2048, 4), 0.53f);
        var hdrp = new HdrpShadowParameters(scales, SoftShadowParameters.HdrpDefault);
        Assert.That(hdrp.Params0, Is.EqualTo(new Vector4(0, 0, 0, 0.5f)));
        Assert.That(hdrp.Params1, Is.EqualTo(new Vector4(1.5f, 0, 0, 1)));
    }

    [Test]
    public void EveryComponentIsFiniteWhateverTheInputs()
    {
        var random = new Random(5);
        float Any() => Adversary.Floats[random.Next(Adversary.Floats.Length)];
        foreach (var matrix in Adversary.Matrices(new LightFrustum().WorldToShadow))
        {
            var parameters = new SoftShadowParameters
            {
                BlockerClump = Any(), MinFilterTexels = Any(), MaxPenumbraMetres = Any(),
                MaxSamplingMetres = Any(), HdrpSearchDegrees = Any(), HdrpMinFilterDegrees = Any(),
            };
            var scales = new CascadeScales(matrix, new AtlasLayout(2048, 4), Any());
            var hdrp = new HdrpShadowParameters(scales, parameters);
            Assert.That(Adversary.IsFinite(hdrp.Params0) && Adversary.IsFinite(hdrp.Params1),
                        $"{hdrp.Params0} {hdrp.Params1}");
        }
    }
}
