namespace Penumbra.Tests;

/// <summary>Unusual settings; tests/golden/parameters.json has the others.</summary>
public class ShadowBiasTests
{
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
