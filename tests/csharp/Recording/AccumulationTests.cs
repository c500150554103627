namespace Penumbra.Tests;

/// <summary>Noise that the feature averages itself: its pass, its history and the way back to the frame before.</summary>
public sealed class AccumulationTests : FeatureTests
{
    [SetUp]
    public void SetUp() => feature.Settings.noise = NoiseMode.Accumulated;

    private string[] Targets() => Draw("Accumulate").Target.Split(" + ");

    private float Noise() => Vector(urp.Device.Draws.Last(), "_PenumbraMainLightParams").z;

    [TestCase(QualityPreset.Low)]
    [TestCase(QualityPreset.Medium)]
    public void FramesAreAveragedAfterTheFilterAndContactShadows(QualityPreset preset)
    {
        feature.Settings.preset = preset;
        Time.frameCount = 5;
        string[] usual = Render();
        Assert.That(usual.Last(), Is.EqualTo("Accumulate"));
        Assert.That(Targets()[0], Is.EqualTo(ShadowChain.OutputName));
        Assert.That(Draw("Accumulate").Textures["_PenumbraSourceTexture"],
                    Is.EqualTo(urp.Device.Draws[usual.Length - 2].Textures["_PenumbraVisibility"]));
        Assert.That(Noise(), Is.EqualTo(5.0f));

        feature.Settings.contactShadowMetres = 0.5f;
        Assert.That(Render().TakeLast(2), Is.EqualTo(new[] { "ScreenTrace", "Accumulate" }));
        Assert.That(Draw("Accumulate").Textures["_PenumbraSourceTexture"], Is.EqualTo(Draw("ScreenTrace").Target));

        feature.Settings.noise = NoiseMode.PerFrame;
        Assert.That(Render(), Has.No.Member("Accumulate"));
        Assert.That(Noise(), Is.EqualTo(5.0f));
    }

    // Forward shaders filter after the chain, and nothing averages their frames.
    [TestCase(NoiseMode.Accumulated, 0.0f)]
    [TestCase(NoiseMode.PerFrame, 5.0f)]
    public void BehindTheChainTheNoiseStandsStill(NoiseMode noise, float expected)
    {
        feature.Settings.noise = noise;
        Time.frameCount = 5;
        Render();
        Assert.That(Noise(), Is.EqualTo(5.0f));
        Assert.That(((Vector4)urp.Device.Uniforms["_PenumbraMainLightParams"]).z, Is.EqualTo(expected));
    }

    [Test]
    public void TheHistoryIsWhatWasWrittenAFrameAgo()
    {
        Render();
        for (int frame = 0; frame < 3; ++frame)
        {
            string written = Targets()[1];
            Render();
            Assert.That(Draw("Accumulate").Textures["_PenumbraHistory"], Is.EqualTo(written));
            Assert.That(Targets()[1], Is.Not.EqualTo(written));
        }
    }

    private Matrix4x4 Matrix(string name, int eye) => ((Matrix4x4[])Draw("Accumulate").Uniforms[name])[eye];

    private static Vector3 Project(in Matrix4x4 matrix, Vector3 point)
    {
        Vector4 h = matrix * new Vector4(point.x, point.y, point.z, 1.0f);
        return new Vector3(h.x / h.w, h.y / h.w, h.z / h.w);
    }

    // A point that this frame's camera sees lies where the frame before saw the same point of the world.
    [Test]
    public void ThePlaceOfASurfaceInTheFrameBeforeIsThatOfItsCamera([Values(0, 2)] int views)
    {
        scene.Views = views;
        Render();
        for (int eye = 0; eye < 2; ++eye)
            Assert.That(Matrix("_PenumbraToPreviousScreen", eye), Is.EqualTo(Matrix4x4.identity), "nothing was before");
        var before = new[] { Matrix("_PenumbraScreenToWorld", 0), Matrix("_PenumbraScreenToWorld", 1) };
        scene.CameraX = 0.3f;
        Render();
        for (int eye = 0; eye < 2; ++eye)
        {
            var now = new Vector3(0.4f, 0.7f, 0.05f);
            Vector3 then = Project(Matrix("_PenumbraToPreviousScreen", eye), now);
            Assert.That(then.x, Is.Not.EqualTo(now.x).Within(0.01f));
            Vector3 seen = Project(Matrix("_PenumbraScreenToWorld", eye), now);
            Vector3 known = Project(before[eye], then);
            Assert.That(known.x, Is.EqualTo(seen.x).Within(1e-4f));
            Assert.That(known.y, Is.EqualTo(seen.y).Within(1e-4f));
            Assert.That(known.z, Is.EqualTo(seen.z).Within(1e-4f));
        }
    }

    [Test]
    public void WhatHasNoNoiseIsNotAveraged()
    {
        Time.frameCount = 5;
        PresetFallback.Choose(feature.Settings, QualityPreset.High);
        Assert.That(Render().Last(), Is.EqualTo("Accumulate"));
        feature.Settings.custom.angularDiameterDegrees = 0.0f;
        Assert.That(Render(), Has.No.Member("Accumulate"));
        Assert.That(Noise(), Is.Zero);
        feature.Settings.contactShadowMetres = 0.5f;
        Assert.That(Render().Last(), Is.EqualTo("Accumulate"), "rays of contact shadows begin at random");
    }

    [Test]
    public void WithoutTheFormatOfTheHistoryTheNoiseStandsStill()
    {
        Time.frameCount = 5;
        PresetFallback.Choose(feature.Settings, QualityPreset.High);
        SystemInfo.Unsupported = GraphicsFormat.R32_UInt;
        Assert.That(Render(), Has.No.Member("Accumulate"));
        Assert.That(feature.Replaced, Does.Contain("R32_UInt"));
        Assert.That(Noise(), Is.Zero);
    }
}
