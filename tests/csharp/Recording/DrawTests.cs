using UnityEditor.ShaderKeywordFilter;

namespace Penumbra.Tests;

public sealed class DrawTests : FeatureTests
{
    [SetUp]
    public void SetUp() => PresetFallback.Choose(feature.Settings, QualityPreset.High);  // with a mask there are four draws

    private static readonly string[] FourTaps = { "PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve" };

    private string[] DrawnWithConservativeMask()
    {
        feature.Settings.custom.conservativeMask = true;
        return Render().Distinct().ToArray();
    }

    [Test]
    public void AConservativeMaskIsMadeFromTheMap([Values(true, false)] bool reversedZ)
    {
        SystemInfo.usesReversedZBuffer = reversedZ;
        Assert.That(DrawnWithConservativeMask(),
                    Is.EqualTo(new[] { "QuarterDepthPlanes", "DepthPlanesMip", "ConservativeMask", "Resolve" }));
        Assert.That(Draw("ConservativeMask").Textures["_PenumbraDepthPlanesTexture"],
                    Is.EqualTo(urp.Device.Draws.First(draw => draw.Pass == "QuarterDepthPlanes").Target));
    }

    // On OpenGL the filter is not the one that the conservative mask decides for.
    [TestCase(GraphicsDeviceType.OpenGLCore)]
    [TestCase(GraphicsDeviceType.OpenGLES3)]
    public void OnOpenGlTheMaskIsOfFourTaps(GraphicsDeviceType device)
    {
        SystemInfo.Device = device;
        Assert.That(DrawnWithConservativeMask(), Is.EqualTo(FourTaps));
    }

    [Test]
    public void WithoutTheFormatOfThePlanesTheMaskIsOfFourTaps()
    {
        SystemInfo.Unsupported = GraphicsFormat.R32G32B32A32_SFloat;
        Assert.That(DrawnWithConservativeMask(), Is.EqualTo(FourTaps));
    }

    [Test]
    public void EachDrawFindsItsTexturesAndSizes()
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.Ultra);
        options.halfResolution = true;
        options.denoise = true;
        Use(options);
        urp.Render(new FakeScene { Width = 1921, Height = 1081 }, feature);

        FakeDevice.DrawCall vertical = Draw("MaskBlurVertical");
        Assert.That(vertical.Textures["_PenumbraSourceTexture"], Is.EqualTo(Draw("MaskBlurHorizontal").Target));
        Assert.That(Vector(vertical, "_PenumbraTargetSize"),
                    Is.EqualTo(new Vector4(481.0f, 271.0f, 1.0f / 481.0f, 1.0f / 271.0f)));
        FakeDevice.DrawCall[] resolves = Draws("Resolve");
        Assert.That(resolves, Has.Length.EqualTo(2));
        FakeDevice.DrawCall resolve = resolves[0];
        Assert.That(resolve.Textures["_PenumbraMaskTexture"], Is.EqualTo(vertical.Target));
        Assert.That(Vector(resolve, "_PenumbraMaskSize"), Is.EqualTo(Vector(vertical, "_PenumbraTargetSize")));
        Assert.That(Vector(resolve, "_PenumbraSourceSize"), Is.EqualTo(Vector4.zero));
        Assert.That(Vector(resolve, "_PenumbraTargetSize").x, Is.EqualTo(961.0f));
        Assert.That(Vector(resolve, "_PenumbraScreenSize"),
                    Is.EqualTo(new Vector4(1921.0f, 1081.0f, 1.0f / 1921.0f, 1.0f / 1081.0f)));
        FakeDevice.DrawCall upsampling = resolves[1];
        Assert.That(upsampling.Textures["_PenumbraSourceTexture"], Is.EqualTo(resolve.Target));
        Assert.That(Vector(upsampling, "_PenumbraSourceSize"), Is.EqualTo(Vector(resolve, "_PenumbraTargetSize")));
        Assert.That(Vector(upsampling, "_PenumbraMaskSize"), Is.EqualTo(Vector4.zero));
        Assert.That(Vector(upsampling, "_PenumbraTargetSize").x, Is.EqualTo(1921.0f));
        Assert.That(resolves.Select(draw => draw.Keywords), Is.All.EqualTo(new[] { "_PENUMBRA_PCSS" }));
        Assert.That(Draw("DenoiseVertical").Target, Is.EqualTo("_ScreenSpaceShadowmapTexture"));
        Assert.That(urp.Device.Draws.Select(draw => draw.Vertices), Is.All.EqualTo(3));
    }

    // The program knows by the sizes that it has no mask and nothing to upsample, whatever a camera before it had.
    [Test]
    public void AnUnmaskedResolveSetsTheSizesOfAbsentTexturesToZero()
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.High);
        options.denoise = true;
        Use(options);
        Render();
        Assert.That(urp.Device.Uniforms["_PenumbraMaskSize"], Is.Not.EqualTo(Vector4.zero));
        Assert.That(urp.Device.Uniforms["_PenumbraSourceSize"], Is.Not.EqualTo(Vector4.zero));
        Use(PresetFallback.Options(QualityPreset.Medium));
        Assert.That(Render(), Is.EqualTo(new[] { "Resolve" }));
        Assert.That(Vector(Draw("Resolve"), "_PenumbraMaskSize"), Is.EqualTo(Vector4.zero));
        Assert.That(Vector(Draw("Resolve"), "_PenumbraSourceSize"), Is.EqualTo(Vector4.zero));
    }

    // A frame leaves textures bound, which are there in the next.
    [Test]
    public void NoResolveHasItsOwnTargetBound([Values] bool mask, [Values] bool half, [Values] bool denoise)
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.High);
        options.mask = mask;
        options.halfResolution = half;
        options.denoise = denoise;
        Use(options);
        for (int frame = 0; frame < 3; ++frame)
        {
            Render();
            foreach (FakeDevice.DrawCall draw in Draws("Resolve"))
                foreach (string name in new[] { "_PenumbraMaskTexture", "_PenumbraSourceTexture" })
                    Assert.That(draw.Textures[name], Is.Not.EqualTo(draw.Target), name + " in frame " + frame);
        }
    }

    // Single-pass XR declares arrays.
    [Test]
    public void WhatIsAbsentIsAnArrayWhereBothEyesAreDrawnAtOnce([Values(1, 2)] int views)
    {
        Use(PresetFallback.Options(QualityPreset.Medium));
        urp.Render(new FakeScene { Views = views }, feature);
        Assert.That(Draw("Resolve").Textures["_PenumbraMaskTexture"], Is.EqualTo(views == 1 ? "black" : "array of 2"));
    }

    [Test]
    public void EachTechniqueHasItsKeywordAlone()
    {
        foreach (ShadowTechnique technique in Enum.GetValues(typeof(ShadowTechnique)))
        {
            ShadowOptions options = ShadowPresets.Options(QualityPreset.Reference);
            options.technique = technique;
            if (options.DrawsVisibility) continue;
            Use(options);
            Render();
            string keyword = technique.Entry().keyword;
            Assert.That(Draw("Resolve").Keywords,
                        Is.EqualTo(keyword == null ? new string[0] : new[] { keyword }), technique.ToString());
        }
    }

    [Test]
    public void AVolumeDecidesForTheCameraThatStandsInIt()
    {
        Volume(QualityPreset.Reference);
        Assert.That(Render().Last(), Is.EqualTo("SmoothFar"));
        VolumeManager.instance.stack.Components.Clear();
        Assert.That(Render(), Is.EqualTo(FourTaps));
    }

    [Test]
    public void DynamicResolutionDrawsIntoAPartOfEachTexture()
    {
        ScalableBufferManager.widthScaleFactor = 0.75f;
        ScalableBufferManager.heightScaleFactor = 0.5f;
        urp.Render(new FakeScene { Width = 1001, Height = 501, DynamicResolution = true }, feature);
        Assert.That(Vector(Draw("Resolve"), "_PenumbraScreenSize").x, Is.EqualTo(751.0f));
        Assert.That(Vector(Draw("Resolve"), "_PenumbraScreenSize").y, Is.EqualTo(251.0f));
        Assert.That(Vector(Draw("PenumbraMask"), "_PenumbraTargetSize").x, Is.EqualTo(189.0f));
        Render(new FakeScene { Width = 1001, Height = 501 });
        Assert.That(Vector(Draw("Resolve"), "_PenumbraScreenSize").x, Is.EqualTo(1001.0f));
    }

    [Test]
    public void NoiseStandsStillUnlessItIsToMove()
    {
        foreach (NoiseMode mode in new[] { NoiseMode.Static, NoiseMode.PerFrame })
        {
            feature.Settings.noise = mode;
            Time.frameCount = 5;
            Render();
            Assert.That(Vector(Draw("Resolve"), "_PenumbraMainLightParams").z,
                        Is.EqualTo(mode == NoiseMode.Static ? 0.0f : 5.0f));
        }
    }

    [Test]
    public void TheBorderBetweenCascadesIsTheFeaturesOrAVolumes()
    {
        float Border()
        {
            Render();
            return Vector(urp.Device.Draws.Last(), "_PenumbraMainLightParams").w;
        }
        Assert.That(Border(), Is.Zero);
        feature.Settings.cascadeBlend = 0.25f;
        Assert.That(Border(), Is.EqualTo(0.25f));
        PenumbraShadowsVolume volume = Volume(QualityPreset.Reference);
        Assert.That(Border(), Is.EqualTo(0.25f));
        volume.cascadeBlend.Set(0.125f);
        Assert.That(Border(), Is.EqualTo(0.125f));
        feature.Settings.cascadeBlend = float.NaN;
        VolumeManager.instance.stack.Components.Clear();
        Assert.That(Border(), Is.Zero);
    }

    [Test]
    public void ContactShadowsAreTheFeaturesUnlessAVolumeHasThem()
    {
        Vector4 Trace()
        {
            Render();
            FakeDevice.DrawCall trace = Draw("ScreenTrace");
            Assert.That(trace.Target, Is.EqualTo("_ScreenSpaceShadowmapTexture"));
            Assert.That(trace.Textures["_PenumbraSourceTexture"], Is.EqualTo(Draw("Resolve").Target));
            return Vector(trace, "_PenumbraScreenTraceParameters0");
        }
        feature.Settings.contactShadowMetres = float.NaN;
        Assert.That(Render(), Has.No.Member("ScreenTrace"));

        feature.Settings.contactShadowMetres = 0.5f;
        Assert.That(Trace().x, Is.EqualTo(0.5f));
        Assert.That(Trace().z, Is.EqualTo(12.0f));
        PenumbraShadowsVolume volume = Volume(QualityPreset.Reference);
        volume.technique.Set(ShadowTechnique.Pcss);
        Assert.That(Trace().x, Is.EqualTo(0.5f));
        volume.contactShadowMetres.overrideState = volume.contactShadowSteps.overrideState = true;
        volume.contactShadowMetres.value = 0.25f;
        volume.contactShadowSteps.value = 24;
        Assert.That(Trace().x, Is.EqualTo(0.25f));
        Assert.That(Trace().z, Is.EqualTo(24.0f));
        feature.Settings.contactShadowMetres = 0.0f;
        Assert.That(Trace().x, Is.EqualTo(0.25f), "a Volume brings them in");
    }

    // A point in front of an off-centre camera is projected as the device does it, and put back by the uniform.
    [TestCase(true, true)]
    [TestCase(true, false)]
    [TestCase(false, true)]
    [TestCase(false, false)]
    public void ScreenToWorldUndoesTheCamera(bool uvStartsAtTop, bool reversed)
    {
        SystemInfo.graphicsUVStartsAtTop = uvStartsAtTop;
        SystemInfo.usesReversedZBuffer = reversed;
        Render(new FakeScene { Views = 2 });
        var matrices = (Matrix4x4[])Draw("Resolve").Uniforms["_PenumbraScreenToWorld"];
        for (int eye = 0; eye < 2; ++eye)
        {
            var world = new Vector4(1.5f, 2.5f, -20.0f, 1.0f);
            Matrix4x4 projection = GL.GetGPUProjectionMatrix(scene.Projections()[eye], true);
            Vector4 clip = projection * (scene.ViewMatrices()[eye] * world);
            float y = clip.y / clip.w;
            float z = clip.z / clip.w;
            var screen = new Vector4(0.5f + 0.5f * clip.x / clip.w, uvStartsAtTop ? 0.5f - 0.5f * y : 0.5f + 0.5f * y,
                                     reversed ? z : 0.5f + 0.5f * z, 1.0f);
            Vector4 back = matrices[eye] * screen;
            Assert.That(back.x / back.w, Is.EqualTo(world.x).Within(1e-3f), "eye " + eye);
            Assert.That(back.y / back.w, Is.EqualTo(world.y).Within(1e-3f), "eye " + eye);
            Assert.That(back.z / back.w, Is.EqualTo(world.z).Within(2e-2f), "eye " + eye);
        }
    }

    [Test]
    public void MaskAndDenoiseHaveTheirParameters()
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.Ultra);
        options.softnessCapMetres = 0.75f;
        options.denoise = true;
        Use(options);
        Render();
        Assert.That(Vector(Draw("MaskBlurHorizontal"), "_PenumbraMaskParameters0"),
                    Is.EqualTo(new Vector4(0.75f, 2.0f, 32.0f, 0.0f)));
        Assert.That(Vector(Draw("DenoiseVertical"), "_PenumbraDenoiseParameters0"),
                    Is.EqualTo(new Vector4(2.0f, 2.0f, 0.25f, 0.0f)));
    }

    private static RenderTextureDescriptor[] Textures(int samples)
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.Ultra);
        options.halfResolution = true;
        options.denoise = true;
        RenderTextureDescriptor target = new FakeScene().Target();
        target.msaaSamples = samples;
        ShadowFrame frame = default;
        UrpFrame.SetSize(ref frame, target);
        return ShadowChain.Of(options).Slots.Select(slot => UrpFrame.Texture(target, slot, frame)).ToArray();
    }

    [TestCase(1)]
    [TestCase(4)]
    [TestCase(8)]
    public void TheChainHasOneSampleWhateverTheCameraHas(int samples) =>
        Assert.That(Textures(samples).Select(texture => texture.msaaSamples), Is.Not.Empty.And.All.EqualTo(1));

    [Test]
    public void ADeviceThatCannotDrawToOneChannelGetsFour()
    {
        Assert.That(Textures(1).Select(texture => texture.graphicsFormat), Is.All.EqualTo(GraphicsFormat.R8_UNorm));
        SystemInfo.Unsupported = GraphicsFormat.R8_UNorm;
        Assert.That(Textures(1).Select(texture => texture.graphicsFormat),
                    Is.Not.Empty.And.All.EqualTo(GraphicsFormat.B8G8R8A8_UNorm));
    }

    [Test]
    public void ALightWithHardShadowsIsSoftToo()
    {
        string[] soft = Render(new FakeScene { Shadows = LightShadows.Soft });
        Assert.That(Render(new FakeScene { Shadows = LightShadows.Hard }), Is.Not.Empty.And.EqualTo(soft));
    }

    [Test]
    public void APlayerKeepsTheScreensVariantsOfEveryShader()
    {
        const BindingFlags constants = BindingFlags.Static | BindingFlags.NonPublic | BindingFlags.Public;
        CustomAttributeData filter = typeof(PenumbraShadows).GetFields(constants).Where(field => field.IsLiteral)
            .SelectMany(field => field.CustomAttributes)
            .Single(attribute => attribute.AttributeType == typeof(SelectIfAttribute));
        object[] arguments = filter.ConstructorArguments.Select(argument => argument.Value).ToArray();
        Assert.That(arguments[0], Is.EqualTo(true), "the value of the constant that it is kept for");
        Assert.That(((IEnumerable<CustomAttributeTypedArgument>)arguments.Last()).Select(name => name.Value),
                    Is.EqualTo(new[] { ShadowKeywords.ScreenName }));
    }

    [Test]
    public void TheAssetRemembersTheShader() => Assert.That(UnityEditor.EditorUtility.Dirty, Has.Member(feature));

    [Test]
    public void WithoutItsShaderTheFrameIsUrps()
    {
        feature.Dispose();
        Shader.Known.Clear();
        feature = new PenumbraShadows();
        feature.Create();
        Render();
        Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.CascadesName));
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.MissingShader));
    }

    /// <summary>A technique without rules has none of their uniforms set.</summary>
    [Test]
    public void RulesForCascadesAreToldWithTheFrameTheyChange()
    {
        const string name = "_PenumbraPcssAngularParameters0From2";
        TechniqueEntry entry = ShadowTechnique.Pcss.Entry();
        Render();
        Assert.That(urp.Device.Uniforms.Keys, Has.None.EqualTo(name));
        try
        {
            entry.cascades = new[]
            {
                new CascadeVector(name, "_PenumbraPcssAngularParameters0", 2, 0.0f, 5.0f, 0.0f, 0.0f),
            };
            Render();
        }
        finally
        {
            entry.cascades = new CascadeVector[0];
        }
        var near = (Vector4)urp.Device.Uniforms["_PenumbraPcssAngularParameters0"];
        Assert.That(urp.Device.Uniforms[name], Is.EqualTo(new Vector4(near.x, 5.0f, near.z, near.w)));
    }

    /// <summary>
    /// Devices of OpenGL ES 3.0 and WebGL 2 go from the default setting down to the tent, which needs neither
    /// kernels nor gathers.
    /// </summary>
    [Test]
    public void ADeviceWithoutTheTechniquesProgramsHasATent(
        [Values] QualityPreset preset, [Values(ShadowTechnique.TiledPcss, ShadowTechnique.Pcss)] ShadowTechnique technique,
        [Values] bool clouds)
    {
        SystemInfo.Device = GraphicsDeviceType.OpenGLES3;
        SystemInfo.graphicsShaderLevel = 35;
        SystemInfo.supportsComputeShaders = false;
        ShadowOptions options = ShadowPresets.Options(preset);
        options.technique = technique;
        feature.Settings.farShadows.clouds = clouds;
        Use(options);
        Render();
        Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
        Assert.That(feature.Drawn.technique, Is.EqualTo(ShadowTechnique.Tent7x7));
        Assert.That(feature.Replaced, Is.Not.Null);
        FakeDevice.DrawCall[] filters = Draws("Resolve");
        Assert.That(filters, Is.Not.Empty);
        foreach (FakeDevice.DrawCall draw in filters)
            Assert.That(draw.Keywords.Intersect(FakeShader.KeywordsOfTarget45()), Is.Empty, draw.Pass);
    }

#if UNITY_6000_0_OR_NEWER
    [Test]
    public void WebGpuCountsAsOpenGl()
    {
        SystemInfo.Device = GraphicsDeviceType.WebGPU;
        Assert.That(DeviceLimits.IsOpenGl);
        Assert.That(DrawnWithConservativeMask(), Is.EqualTo(FourTaps));
    }
#endif

    /// <summary>A draw that the editor skips leaves its target with the content of another frame.</summary>
    [Test]
    public void TheEditorCompilesBeforeItDraws()
    {
        feature.Settings.preset = QualityPreset.High;
        Render();
        Assert.That(urp.Device.Draws, Is.Not.Empty);
        Assert.That(urp.Device.Draws.Select(draw => draw.CompilesAsynchronously), Is.All.False);
        Assert.That(urp.Device.CompilesAsynchronously, "as before, for others");
    }
}
