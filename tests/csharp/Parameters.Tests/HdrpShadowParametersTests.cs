using NUnit.Framework;

namespace Penumbra.Tests;

[TestFixture]
public class HdrpShadowParametersTests
{
    private static double TanHalf(double degrees) => Math.Tan(degrees * Math.PI / 360.0);

    private static void AssertClose(float actual, double expected) =>
        Assert.That(actual / expected, Is.EqualTo(1.0).Within(1e-6), $"{actual} for {expected}");

    // The expected values come from the device's projection, as HDRP has it, not from the shadow matrix.
    [Test]
    public void TheyFollowFromTheDeviceProjection([Values] bool reversedZ,
                                                  [Values(0.53, 11.0, 25.0)] double degrees)
    {
        var frustum = new LightFrustum { ReversedZ = reversedZ };
        var hdrp = new HdrpShadowParameters(frustum.Scales((float)degrees), SoftShadowParameters.HdrpDefault);
        var scale = Math.Abs(frustum.M00 / frustum.DeviceM22);
        var light = TanHalf((float)degrees);
        AssertClose(hdrp.Params0.x, light * scale);
        AssertClose(hdrp.Params0.y, 1.0 / (light * scale));
        AssertClose(hdrp.Params0.z, 0.56 / (2.0 * light));
        AssertClose(hdrp.Params0.w, 0.5);
        AssertClose(hdrp.Params1.x, 1.5);
        AssertClose(hdrp.Params1.y, 1.0 / (TanHalf(Math.Max(12.0, degrees)) * scale));
        AssertClose(hdrp.Params1.z, 1.0 / (TanHalf(Math.Max(12.0, degrees)) * scale));
        AssertClose(hdrp.Params1.w, 1.0);
    }

    [Test]
    public void AWiderFilterConeIsItsOwn()
    {
        var frustum = new LightFrustum();
        var parameters = SoftShadowParameters.HdrpDefault;
        parameters.HdrpMinFilterDegrees = 20.0f;
        var hdrp = new HdrpShadowParameters(frustum.Scales(0.53f), parameters);
        AssertClose(hdrp.Params1.y / hdrp.Params1.z, TanHalf(12.0) / TanHalf(20.0));
    }

    [Test]
    public void APointLightHasNoInverseAndTheWholeRangeOfBlockers()
    {
        var frustum = new LightFrustum();
        var hdrp = new HdrpShadowParameters(frustum.Scales(0.0f), SoftShadowParameters.HdrpDefault);
        Assert.That(hdrp.Params0.x, Is.Zero);
        Assert.That(hdrp.Params0.y, Is.Zero);
        AssertClose(hdrp.Params0.z, frustum.Range);
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
