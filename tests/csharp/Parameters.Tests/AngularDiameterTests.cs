using System.Globalization;
using System.Threading;

namespace Penumbra.Tests;

/// <summary>The ends of the range; tests/golden/parameters.json has the rest.</summary>
public class AngularDiameterTests
{
    [Test]
    public void NoAngleIsExactlyNoTangent() =>
        Assert.That(BitConverter.SingleToInt32Bits(AngularDiameter.TanHalf(-0.0f)), Is.Zero);

    [TestCase(60.0f, 30.0f)]
    [TestCase(float.PositiveInfinity, 30.0f)]
    [TestCase(-1.0f, 0.0f)]
    [TestCase(float.NegativeInfinity, 0.0f)]
    [TestCase(float.NaN, 0.0f)]
    public void OutsideCountsAsTheNearerEnd(float degrees, float nearest) =>
        Assert.That(AngularDiameter.TanHalf(degrees), Is.EqualTo(AngularDiameter.TanHalf(nearest)));

    [TestCase(float.NaN)]
    [TestCase(-1.0f)]
    [TestCase(float.NegativeInfinity)]
    public void WhatIsNoTangentIsNoAngle(float tanHalf) => Assert.That(AngularDiameter.FromTanHalf(tanHalf), Is.Zero);

    [Test]
    public void TheFullCircleHasItsEnds()
    {
        Assert.That(AngularDiameter.FromTanHalf(1.0f), Is.EqualTo(90.0f));
        Assert.That(AngularDiameter.FromTanHalf(float.PositiveInfinity), Is.EqualTo(180.0f));
    }

    [TestCase(0.0f)]
    [TestCase(0.53f)]
    [TestCase(30.0f)]
    public void NothingIsWrongInRange(float degrees) => Assert.That(AngularDiameter.Problem(degrees), Is.Null);

    [TestCase(45.5f, "45.5")]
    [TestCase(-0.25f, "-0.25")]
    [TestCase(float.NaN, "NaN")]
    public void TheMessageNamesValueRangeAndWayOut(float degrees, string printed)
    {
        var culture = Thread.CurrentThread.CurrentCulture;
        try
        {
            Thread.CurrentThread.CurrentCulture = new CultureInfo("de-DE");
            Assert.That(AngularDiameter.Problem(degrees),
                        Is.EqualTo($"angular diameter is {printed}, outside 0 .. 30 degrees; it is the full " +
                                   "angle of the light's disc, and the sun's is 0.53"));
        }
        finally
        {
            Thread.CurrentThread.CurrentCulture = culture;
        }
    }
}
