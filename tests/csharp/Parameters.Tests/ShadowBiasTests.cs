using NUnit.Framework;

namespace Penumbra.Tests;

[TestFixture]
public class ShadowBiasTests
{
    [Test]
    public void BothRoadsToATexelAgree([Values] SoftShadowKernel kernel)
    {
        var frustum = new LightFrustum();
        var projection = Matrix4x4.identity;
        projection.m00 = (float)frustum.M00;
        var ofProjection = ShadowBias.OfProjection(projection, frustum.Layout.TileResolution, 1.0f, 2.0f, kernel);
        var ofCascade = ShadowBias.OfCascade(frustum.Scales(0.53f), 1.0f, 2.0f, kernel);
        Assert.That(ofCascade.x, Is.EqualTo(ofProjection.x).Within(1e-8));
        Assert.That(ofCascade.y, Is.EqualTo(ofProjection.y).Within(1e-8));
    }

    // The bias is 20 m over 1024 texels, twice, times the kernel's 3.5 texels.
    [Test]
    public void TheBiasIsTexelsOfTheKernel()
    {
        var projection = Matrix4x4.identity;
        projection.m00 = 0.1f;
        var bias = ShadowBias.OfProjection(projection, 1024, 1.0f, 2.0f, SoftShadowKernel.High);
        Assert.That(bias.x, Is.EqualTo(-3.5 * 20.0 / 1024.0).Within(1e-8));
        Assert.That(bias.y, Is.EqualTo(-7.0 * 20.0 / 1024.0).Within(1e-8));
    }

    [Test]
    public void NoBiasIsNotMinusZero()
    {
        var bias = ShadowBias.OfProjection(Matrix4x4.identity, 1024, 0.0f, 0.0f, SoftShadowKernel.Low);
        Assert.That(1.0f / bias.x, Is.EqualTo(float.PositiveInfinity));
        Assert.That(1.0f / bias.y, Is.EqualTo(float.PositiveInfinity));
    }

    [Test]
    public void AQualityFromAnotherVersionIsMedium() =>
        Assert.That(ShadowBias.KernelRadiusTexels((SoftShadowKernel)17), Is.EqualTo(2.5f));

    [Test]
    public void WhateverTheInputsItIsFinite()
    {
        foreach (var m00 in Adversary.Floats)
        foreach (var setting in Adversary.Floats)
        foreach (var resolution in Adversary.Ints)
        {
            var projection = Matrix4x4.identity;
            projection.m00 = m00;
            var bias = ShadowBias.OfProjection(projection, resolution, setting, 1.0f, SoftShadowKernel.High);
            Assert.That(float.IsFinite(bias.x) && float.IsFinite(bias.y), $"{m00} {setting} {resolution}");
        }
    }
}
