namespace Penumbra.Tests;

/// <summary>
/// The tests say what a frame draws and tells its passes of the ground beyond the cascades, and of clouds.
/// </summary>
public sealed class FarShadowsTests : FeatureTests
{
    [SetUp]
    public void SetUp() => PresetFallback.Choose(feature.Settings, QualityPreset.Medium);  // it has one draw

    [TearDown]
    public void DisableTheGround()
    {
        foreach (FarShadowGround ground in made) Enable(ground, false);
        made.Clear();
    }

    private readonly List<FarShadowGround> made = new();

    // The engine enables components in this way.
    private static void Enable(FarShadowGround ground, bool on) =>
        typeof(FarShadowGround).GetMethod(on ? "OnEnable" : "OnDisable", BindingFlags.Instance | BindingFlags.NonPublic)
            .Invoke(ground, null);

    private FarShadowGround Ground(Action<FarShadowGround> set, Terrain beside = null)
    {
        var owner = new GameObject("ground");
        if (beside != null)
        {
            beside.Owner = owner;
            owner.Components.Add(beside);
        }
        FarShadowGround ground = owner.AddComponent<FarShadowGround>();
        set(ground);
        Enable(ground, true);
        made.Add(ground);
        return ground;
    }

    private static Terrain Valley(float x = -100.0f, float z = 50.0f)
    {
        var terrain = new Terrain
        {
            terrainData = new TerrainData { heightmapResolution = 513, size = new Vector3(1000.0f, 600.0f, 2000.0f) },
        };
        terrain.transform.position = new Vector3(x, 20.0f, z);
        return terrain;
    }

    [Test]
    public void AFeatureBeginsWithoutThem()
    {
        Ground(ground => ground.Terrain = Valley());
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(feature.MissingGround, Is.Null);
        Assert.That(keywords.ReceiversAtOpaques, Is.Null, "only URP sets it");
    }

    [Test]
    public void ATerrainsHeightsAreSearchedAfterTheFilter()
    {
        Ground(ground => ground.Terrain = Valley());
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        feature.Settings.farShadows.parameters.heightSteps = 48;
        feature.Settings.custom.angularDiameterDegrees = 2.0f;
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve", "FarShadows" }));
        FakeDevice.DrawCall far = Draw("FarShadows");
        Assert.That(far.Target, Is.EqualTo("_ScreenSpaceShadowmapTexture"));
        Assert.That(far.Textures["_PenumbraSourceTexture"], Is.EqualTo(Draw("Resolve").Target));
        Assert.That(far.Textures["_PenumbraGroundHeightsTexture"], Is.EqualTo("heights"));
        Assert.That(Vector(far, "_PenumbraGroundArea"), Is.EqualTo(new Vector4(-100.0f, 50.0f, 1000.0f, 2000.0f)));
        Assert.That(Vector(far, "_PenumbraGroundHeights"), Is.EqualTo(new Vector4(20.0f, 620.0f, 513.0f, 513.0f)));
        Assert.That(Vector(far, "_PenumbraShadowDistance").x, Is.EqualTo(scene.Distance));
        Assert.That(Vector(far, "_PenumbraFarShadowsParameters0").y, Is.EqualTo(48.0f));
        Vector4 sun = Vector(far, "_PenumbraTowardSun");
        Assert.That((sun.x, sun.y, sun.z), Is.EqualTo((-0.6f, 0.8f, 0.0f)));
        Assert.That(sun.w, Is.EqualTo(Math.PI / 180.0).Within(1e-7));
        Assert.That(far.Keywords, Has.Member("_PENUMBRA_FAR_HEIGHTS").And.No.Member("_PENUMBRA_FAR_HORIZON")
                        .And.No.Member("_PENUMBRA_CLOUDS"));
    }

    /// <summary>The highest height is 32766 of 65535, in one channel or in two, the low byte first.</summary>
    [TestCase(GraphicsFormat.R16_UNorm, 32766.0 / 65535.0, 0.0)]
    [TestCase(GraphicsFormat.R8G8_UNorm, (32766 % 256) / 255.0, (32766 / 256) / 255.0)]
    public void TheTopOfATerrainIsOneWhateverItsFormat(GraphicsFormat format, double red, double green)
    {
        TerrainData.Format = format;
        Ground(ground => ground.Terrain = Valley());
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Render();
        Vector4 channels = Vector(Draw("FarShadows"), "_PenumbraGroundChannels");
        Assert.That(red * channels.x + green * channels.y, Is.EqualTo(1.0).Within(1e-6));
    }

    [Test]
    public void TheTerrainBesideTheComponentNeedsNoAssignment()
    {
        Ground(ground => { }, Valley());
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Render();
        Assert.That(Vector(Draw("FarShadows"), "_PenumbraGroundArea").x, Is.EqualTo(-100.0f));
    }

    private static FarShadowGround Baked(FarShadowGround ground)
    {
        ground.HeightMap = new Texture2D { name = "baked", width = 257, height = 129 };
        ground.HorizonFirst = new Texture2D { name = "first" };
        ground.HorizonSecond = new Texture2D { name = "second" };
        ground.CornerMetres = new Vector2(1.0f, 2.0f);
        ground.SizeMetres = new Vector2(300.0f, 400.0f);
        ground.HeightsMetres = new Vector2(-5.0f, 70.0f);
        return ground;
    }

    [Test]
    public void BakedTexturesStandInForATerrain()
    {
        Ground(ground => Baked(ground));
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Render();
        FakeDevice.DrawCall far = Draw("FarShadows");
        Assert.That(far.Textures["_PenumbraGroundHeightsTexture"], Is.EqualTo("baked"));
        Assert.That(Vector(far, "_PenumbraGroundArea"), Is.EqualTo(new Vector4(1.0f, 2.0f, 300.0f, 400.0f)));
        Assert.That(Vector(far, "_PenumbraGroundHeights"), Is.EqualTo(new Vector4(-5.0f, 70.0f, 257.0f, 129.0f)));
        Assert.That(Vector(far, "_PenumbraGroundChannels"), Is.EqualTo(new Vector4(1.0f, 0.0f, 0.0f, 0.0f)));
    }

    [Test]
    public void HorizonAnglesAreReadFromTwoTextures()
    {
        Ground(ground => Baked(ground));
        feature.Settings.farShadows.mode = FarShadowMode.HorizonAngles;
        Render();
        FakeDevice.DrawCall far = Draw("FarShadows");
        Assert.That(far.Textures["_PenumbraHorizonFirstTexture"], Is.EqualTo("first"));
        Assert.That(far.Textures["_PenumbraHorizonSecondTexture"], Is.EqualTo("second"));
        Assert.That(far.Keywords, Has.Member("_PENUMBRA_FAR_HORIZON").And.No.Member("_PENUMBRA_FAR_HEIGHTS"));
    }

    private static TestCaseData Lack(FarShadowMode mode, string problem, Action<FarShadowGround> set) =>
        new(set, mode, problem);

    private static readonly TestCaseData[] Lacking =
    {
        Lack(FarShadowMode.HeightMap, FarShadowGround.NoHeights, ground => { }),
        Lack(FarShadowMode.HeightMap, FarShadowGround.NoHeights, ground => ground.Terrain = new Terrain()),
        Lack(FarShadowMode.HorizonAngles, FarShadowGround.NoAngles, ground => ground.Terrain = Valley()),
        Lack(FarShadowMode.HorizonAngles, FarShadowGround.NoAngles,
             ground => Baked(ground).HorizonSecond.Destroyed = true),
        Lack(FarShadowMode.HorizonAngles, FarShadowGround.NoSize,
             ground => Baked(ground).SizeMetres = new Vector2(float.NaN, 10.0f)),
        Lack(FarShadowMode.HeightMap, FarShadowGround.NoRange,
             ground => Baked(ground).HeightsMetres = new Vector2(5.0f, 5.0f)),
    };

    [TestCaseSource(nameof(Lacking))]
    public void WhatTheGroundLacksIsSaidAndTheFrameIsAsWithout(Action<FarShadowGround> set, FarShadowMode mode,
                                                               string problem)
    {
        feature.Settings.farShadows.mode = mode;
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(feature.MissingGround, Is.EqualTo(FarShadowGround.NoGround));
        FarShadowGround ground = Ground(set);
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(feature.MissingGround, Is.EqualTo(problem));
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
        Assert.That(keywords.ReceiversAtOpaques, Is.Null, "receivers fade as without");

        Enable(ground, false);
        Render();
        Assert.That(feature.MissingGround, Is.EqualTo(FarShadowGround.NoGround));
        Ground(ground => Baked(ground));
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve", "FarShadows" }));
        Assert.That(feature.MissingGround, Is.Null);
    }

    /// <summary>A nearer ground that lacks something does not count.</summary>
    [Test]
    public void ACameraHasTheNearestGround()
    {
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Ground(ground => { });
        Ground(ground => ground.Terrain = Valley(5000.0f));
        Ground(ground => ground.Terrain = Valley(1100.0f));
        Ground(ground => ground.Terrain = Valley(-3000.0f));
        Camera camera = scene.MakeCamera();
        foreach ((float x, float corner) in new[] { (0.0f, 1100.0f), (1500.0f, 1100.0f), (3400.0f, 1100.0f),
                                                    (3800.0f, 5000.0f), (-4000.0f, -3000.0f) })
        {
            camera.transform.position = new Vector3(x, 1e4f, 100.0f);
            Render();
            Assert.That(Vector(Draw("FarShadows"), "_PenumbraGroundArea").x, Is.EqualTo(corner), x.ToString());
        }
    }

    [Test]
    public void CloudsAreDrawnIntoAMapAroundTheCameraAndMoveWithTheWind()
    {
        feature.Settings.farShadows.clouds = true;
        feature.Settings.farShadows.cloudLayer.cloudCoverage = 0.25f;
        feature.Settings.farShadows.windMetresPerSecond = new Vector2(3.0f, -2.0f);
        Time.timeAsDouble = 10.0;
        scene.MakeCamera().transform.position = new Vector3(7.0f, 8.0f, 9.0f);
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve", "CloudMap", "FarShadows" }));
        FakeDevice.DrawCall far = Draw("FarShadows");
        Assert.That(far.Textures["_PenumbraCloudTexture"], Is.EqualTo(Draw("CloudMap").Target));
        Assert.That(Vector(Draw("CloudMap"), "_PenumbraTargetSize").x, Is.EqualTo(512.0f));
        foreach (FakeDevice.DrawCall draw in new[] { Draw("CloudMap"), far })
        {
            Assert.That(Vector(draw, "_PenumbraCloudWind"), Is.EqualTo(new Vector4(30.0f, -20.0f, 0.0f, 0.0f)));
            Assert.That(Vector(draw, "_PenumbraCloudCentre"), Is.EqualTo(new Vector4(7.0f, 8.0f, 9.0f, 0.0f)));
            Assert.That(Vector(draw, "_PenumbraCloudParameters1").x, Is.EqualTo(0.25f));
        }
        Assert.That(far.Keywords, Has.Member("_PENUMBRA_CLOUDS").And.No.Member("_PENUMBRA_FAR_HEIGHTS"));
        Assert.That(feature.MissingGround, Is.Null);

        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve", "CloudMap", "FarShadows" }), "clouds need no ground");
        Assert.That(feature.MissingGround, Is.EqualTo(FarShadowGround.NoGround));
        Ground(ground => Baked(ground));
        Render();
        Assert.That(Draw("FarShadows").Keywords, Has.Member("_PENUMBRA_CLOUDS").And.Member("_PENUMBRA_FAR_HEIGHTS"));
        feature.Settings.farShadows.windMetresPerSecond = new Vector2(float.NaN, float.PositiveInfinity);
        Render();
        Assert.That(Vector(Draw("CloudMap"), "_PenumbraCloudWind"), Is.EqualTo(Vector4.zero));
    }

    [Test]
    public void ADeviceThatCannotDrawTheCloudsHasNone()
    {
        Ground(ground => Baked(ground));
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        feature.Settings.farShadows.clouds = true;
        SystemInfo.Unsupported = GraphicsFormat.R16_UNorm;
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve", "FarShadows" }));
        Assert.That(feature.Replaced, Does.Contain("R16_UNorm"));
        Assert.That(feature.Drawn.clouds, Is.False);
    }

    /// <summary>Both eyes read one map, which is drawn once.</summary>
    [Test]
    public void TheMapOfCloudsIsDrawnForBothEyes()
    {
        const string stereo = "STEREO_INSTANCING_ON";
        feature.Settings.farShadows.clouds = true;
        scene.Views = 2;
        urp.Device.SetKeyword(stereo, true);
        Render();
        Assert.That(Draw("CloudMap").GlobalKeywords, Has.No.Member(stereo));
        Assert.That(Draw("FarShadows").GlobalKeywords, Has.Member(stereo));
    }

    [Test]
    public void ContactShadowsComeBeforeThem()
    {
        Ground(ground => Baked(ground));
        feature.Settings.contactShadowMetres = 0.5f;
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve", "ScreenTrace", "FarShadows" }));
        Assert.That(Draw("FarShadows").Textures["_PenumbraSourceTexture"], Is.EqualTo(Draw("ScreenTrace").Target));
    }

    /// <summary>
    /// A camera that is farther from the ground than the shadow distance has no casters in its cascades either.
    /// </summary>
    [TestCase(false, -1)]
    [TestCase(true, 1)]
    public void WhereNothingCastsIntoTheCascadesTheyAreDrawnOverALitScreen(bool casters, int cascadeWithoutView)
    {
        Ground(ground => Baked(ground));
        scene.Casters = casters;
        scene.CascadeWithoutView = cascadeWithoutView;
        string ofUrp = new FakeUrp().Render(scene).AtTransparents;
        Assert.That(Render(), Is.Empty);
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.NoCasters).Or.EqualTo(SkipReason.InvalidCascade));

        feature.Settings.contactShadowMetres = 0.5f;
        feature.Settings.preset = QualityPreset.High;
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        feature.Settings.farShadows.clouds = true;
        Assert.That(Render(), Is.EqualTo(new[] { "clear", "CloudMap", "FarShadows" }));
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
        FakeDevice.DrawCall lit = Draw("clear"), far = Draw("FarShadows");
        Assert.That(lit.Cleared.r, Is.EqualTo(1.0f));
        Assert.That(far.Textures["_PenumbraSourceTexture"], Is.EqualTo(lit.Target));
        Assert.That(Vector(far, "_MainLightShadowParams").x, Is.EqualTo(0.75f), "the light's strength");
        Assert.That(far.Keywords, Has.Member("_PENUMBRA_FAR_HEIGHTS").And.Member("_PENUMBRA_CLOUDS"));
        Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
        Assert.That(Fade(keywords.ReceiversAtOpaques.Value, 1e4), Is.Zero);
        Assert.That(keywords.AtTransparents, Is.EqualTo(ofUrp));
        Assert.That(Fade((Vector4)urp.Device.Uniforms["_MainLightShadowParams"], 1e4), Is.EqualTo(1.0), "as beside URP's empty map");

        feature.Settings.farShadows.mode = FarShadowMode.Off;
        feature.Settings.farShadows.clouds = false;
        Assert.That(Render(), Is.Empty, "URP's own");
    }

    [TestCase(ShadowmaskMode.DistanceShadowmask, MixedLightingMode.Shadowmask, LightmapBakeType.Mixed, true, true, true)]
    [TestCase(ShadowmaskMode.DistanceShadowmask, MixedLightingMode.Shadowmask, LightmapBakeType.Mixed, true, false, false)]
    [TestCase(ShadowmaskMode.DistanceShadowmask, MixedLightingMode.Shadowmask, LightmapBakeType.Mixed, false, true, false)]
    [TestCase(ShadowmaskMode.Shadowmask, MixedLightingMode.Shadowmask, LightmapBakeType.Mixed, true, true, false)]
    [TestCase(ShadowmaskMode.DistanceShadowmask, MixedLightingMode.IndirectOnly, LightmapBakeType.Mixed, true, true, false)]
    [TestCase(ShadowmaskMode.DistanceShadowmask, MixedLightingMode.Shadowmask, LightmapBakeType.Realtime, true, true, false)]
    public void DistanceShadowmaskKeepsItsBakedPart(ShadowmaskMode mode, MixedLightingMode mixed, LightmapBakeType type,
                                                    bool supported, bool clouds, bool keeps)
    {
        QualitySettings.shadowmaskMode = mode;
        scene.Baking = new LightBakingOutput { lightmapBakeType = type, mixedLightingMode = mixed };
        scene.MixedLighting = supported;
        feature.Settings.farShadows.clouds = clouds;
        Render();
        Assert.That(keywords.AtOpaques.Split(' ').Contains("LIGHTMAP_SHADOW_MIXING"), Is.EqualTo(keeps));
        Assert.That(keywords.AtTransparents, Does.Not.Contain("LIGHTMAP_SHADOW_MIXING"));
    }

    /// <summary>A Volume's preset is one of the filter alone.</summary>
    [Test]
    public void AVolumesPresetKeepsThem()
    {
        Ground(ground => Baked(ground));
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        Volume(QualityPreset.Medium);
        Assert.That(Render(), Has.Member("FarShadows"));
    }

    /// <summary>The shader has the variant that each frame draws with.</summary>
    [Test]
    public void TheShaderHasWhatFramesDrawWith()
    {
        Ground(ground => Baked(ground));
        var variants = FakeShader.FarVariants()["FarShadows"];
        foreach (FarShadowMode mode in Enum.GetValues(typeof(FarShadowMode)))
            foreach (bool clouds in new[] { false, true })
            {
                if (mode == FarShadowMode.Off && !clouds) continue;
                feature.Settings.farShadows.mode = mode;
                feature.Settings.farShadows.clouds = clouds;
                Render();
                string[] on = Draw("FarShadows").Keywords.Intersect(variants.SelectMany(set => set)).ToArray();
                Assert.That(variants.Count(set => set.SetEquals(on)), Is.EqualTo(1), mode + " " + clouds);
                Assert.That(on.Length, Is.EqualTo((mode == FarShadowMode.Off ? 0 : 1) + (clouds ? 1 : 0)));
            }
    }

    [Test]
    public void FramesAllocateNothing()
    {
        Ground(ground => Baked(ground));
        feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
        feature.Settings.farShadows.clouds = true;
        feature.Settings.contactShadowMetres = 0.5f;
        var camera = new SteadyCamera(scene);
        CommandBuffer.Silent = true;
        void Frames(int count)
        {
            for (int frame = 0; frame < count; ++frame, ++Time.frameCount) camera.Render(feature);
        }

        Frames(3);
        Assert.That((feature.LastSkip, feature.MissingGround), Is.EqualTo((SkipReason.None, (string)null)));
        Assert.That(Allocations.Of(() => Frames(1000)), Is.Zero);
    }

    // This is GetMainLightShadowFade of URP's Shadows.hlsl.
    private static double Fade(Vector4 receivers, double distance) =>
        Math.Min(Math.Max(distance * distance * receivers.z + receivers.w, 0.0), 1.0);

    [TestCase(FarShadowMode.HeightMap, false)]
    [TestCase(FarShadowMode.HorizonAngles, true)]
    [TestCase(FarShadowMode.Off, true)]
    public void OpaqueSurfacesDoNotFadeAndTransparentOnesDoAsWithUrp(FarShadowMode mode, bool clouds)
    {
        Ground(ground => Baked(ground));
        feature.Settings.farShadows.mode = mode;
        feature.Settings.farShadows.clouds = clouds;
        scene.Distance = 120.0f;
        scene.Border = 0.25f;
        Render();
        Vector4 opaque = keywords.ReceiversAtOpaques.Value;
        var transparent = (Vector4)urp.Device.Uniforms["_MainLightShadowParams"];
        foreach (double distance in new[] { 0.0, 60.0, 119.0, 121.0, 1e5 })
            Assert.That(Fade(opaque, distance), Is.Zero, distance.ToString());
        Assert.That((opaque.x, opaque.y), Is.EqualTo((transparent.x, transparent.y)));
        Assert.That(transparent.x, Is.EqualTo(0.75f), "the light's strength");
        Assert.That(Fade(transparent, 90.0), Is.EqualTo(0.0).Within(1e-5), "where the border begins");
        Assert.That(Fade(transparent, 120.0), Is.EqualTo(1.0).Within(1e-5));
        double half = Math.Sqrt(0.5 * (90.0 * 90.0 + 120.0 * 120.0));
        Assert.That(Fade(transparent, half), Is.EqualTo(0.5).Within(1e-5), "linear in the squared distance");
    }

    [Test]
    public void WithoutABorderUrpsFadeIsAStep()
    {
        Vector4 receivers = ReceiverFade.OfUrp(new Light(), true, 50.0f, 0.0f);
        Assert.That(Fade(receivers, 49.999), Is.Zero);
        Assert.That(Fade(receivers, 50.001), Is.EqualTo(1.0));
    }

    [TestCase(true, LightShadows.Soft, null, ExpectedResult = 1.0f)]
    [TestCase(true, LightShadows.Soft, SoftShadowQuality.Low, ExpectedResult = 1.0f)]
    [TestCase(true, LightShadows.Soft, SoftShadowQuality.High, ExpectedResult = 3.0f)]
    [TestCase(true, LightShadows.Soft, SoftShadowQuality.UsePipelineSettings, ExpectedResult = 3.0f)]
    [TestCase(true, LightShadows.Hard, SoftShadowQuality.High, ExpectedResult = 0.0f)]
    [TestCase(false, LightShadows.Soft, SoftShadowQuality.High, ExpectedResult = 0.0f)]
    public float TransparentSurfacesAreAsSoftAsUrpHasThem(bool supported, LightShadows shadows, object quality)
    {
        var asset = new UniversalRenderPipelineAsset();
        asset.SetSoftShadowQuality(SoftShadowQuality.High);
        GraphicsSettings.currentRenderPipeline = asset;
        var owner = new GameObject("sun");
        Light light = owner.AddComponent<Light>();
        light.shadows = shadows;
        if (quality != null)
            owner.AddComponent<UniversalAdditionalLightData>().softShadowQuality = (SoftShadowQuality)quality;
        return ReceiverFade.OfUrp(light, supported, 50.0f, 0.1f).y;
    }
}
