namespace Penumbra.Tests;

public sealed class ShadowStateTests
{
    private sealed class Asset : UniversalRenderPipelineAsset { }

    private static Matrix4x4 Rows(Vector4 x, Vector4 y, Vector4 z)
    {
        Matrix4x4 m = Matrix4x4.identity;
        m.m00 = x.x; m.m01 = x.y; m.m02 = x.z; m.m03 = x.w;
        m.m10 = y.x; m.m11 = y.y; m.m12 = y.z; m.m13 = y.w;
        m.m20 = z.x; m.m21 = z.y; m.m22 = z.z; m.m23 = z.w;
        return m;
    }

    // This is what URP has uploaded: `penumbra constants --cascades 2 --light 1.5` gives these matrices.
    private static void Upload()
    {
        Shader.Globals["_PenumbraMainLightParams"] = new Vector4(2.0f, AngularDiameter.TanHalf(1.5f), 0.0f, 0.0f);
        Shader.Globals["_MainLightShadowParams"] = new Vector4(1.0f, 2.0f, 0.0f, 0.0f);
        Shader.Globals["_MainLightWorldToShadow"] = new[]
        {
            Rows(new Vector4(0.014548679f, 0, -0.008729207f, 0.35888672f),
                 new Vector4(0.014108529f, 0.019987084f, 0.023514217f, 0.171875f),
                 new Vector4(-0.010223888f, 0.027263703f, -0.017039813f, 0.66327566f)),
            Rows(new Vector4(0.0036371697f, 0, -0.0021823018f, 0.8588867f),
                 new Vector4(0.0035271323f, 0.004996771f, 0.005878554f, 0.19726562f),
                 new Vector4(-0.0025689725f, 0.0068505933f, -0.004281621f, 0.7015873f)),
            Matrix4x4.zero, Matrix4x4.zero, Matrix4x4.zero,
        };
        Shader.Globals["_CascadeShadowSplitSpheres0"] = new Vector4(0.0f, 1.7f, 12.5f, 0.0f);
        Shader.Globals["_CascadeShadowSplitSpheres1"] = new Vector4(0.0f, 1.7f, 50.0f, 0.0f);
        Shader.Globals["_CascadeShadowSplitSphereRadii"] = new Vector4(216.69238f, 3467.0781f, 0.0f, 0.0f);
    }

    [TearDown]
    public void TearDown() => Shader.Globals.Clear();

    private static bool Read(out ShadowState state)
    {
        var sun = new Light { shadows = LightShadows.Soft };
        sun.transform.forward = new Vector3(0.30304576f, -0.80812204f, 0.50507628f);
        var asset = new Asset { mainLightShadowmapResolution = 2048, shadowDepthBias = 1.0f, shadowNormalBias = 0.5f };
        return ShadowStateExport.Read(asset, sun, out state);
    }

    /// <summary>The same file goes through `penumbra constants --matrices` in a test of its own.</summary>
    [Test]
    public void AFramesStateIsWrittenAsTheProgramReadsIt()
    {
        Upload();
        Assert.That(Read(out ShadowState state));
        string golden = Path.Combine(FakeShader.PackageRoot(), "tests", "golden", "exported_shadow_state.json");
        Assert.That(ShadowStateJson.Write(state), Is.EqualTo(File.ReadAllText(golden)));
    }

    [Test]
    public void BeforeTheFirstShadowThereIsNothingToExport() => Assert.That(Read(out ShadowState _), Is.False);
}
