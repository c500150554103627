using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Tests
{
    /// <summary>A debug view is the last draw of its camera, over the picture, and changes nothing else.</summary>
    public sealed class DebugViewTests
    {
        private static readonly DebugView[] Views =
            Enum.GetValues(typeof(DebugView)).Cast<DebugView>().Where(view => view != DebugView.None).ToArray();

        private PenumbraShadows feature;
        private FakeUrp urp;

        [SetUp]
        public void SetUp()
        {
            FakeShader.Install();
            feature = new PenumbraShadows();
            feature.Create();
            PresetFallback.Choose(feature.Settings, QualityPreset.High);
            urp = new FakeUrp();
        }

        [TearDown]
        public void TearDown()
        {
            Debug.isDebugBuild = true;
            SystemInfo.supportsComputeShaders = true;
            VolumeManager.instance.stack.Components.Clear();
            feature.Dispose();
        }

        private string[] Passes() => urp.Device.Draws.Select(draw => draw.Pass).ToArray();

        [TestCase(QualityPreset.Custom)]
        [TestCase(QualityPreset.Low)]
        [TestCase(QualityPreset.High)]
        public void EachIsDrawnOverTheCamerasPictureAfterTheChain(QualityPreset preset)
        {
            feature.Settings.preset = preset;
            urp.Render(new FakeScene(), feature);
            string[] chain = Passes();
            foreach (DebugView view in Views)
            {
                urp = new FakeUrp();
                feature.Settings.debugView = view;
                FrameKeywords keywords = urp.Render(new FakeScene(), feature);
                Assert.That(Passes(), Is.EqualTo(chain.Append(view.ToString())));
                FakeDevice.DrawCall draw = urp.Device.Draws.Last();
                Assert.That(draw.Target, Is.EqualTo("_CameraColorTexture"), view.ToString());
                Assert.That(draw.Vertices, Is.EqualTo(3));
                Assert.That(draw.Textures["_ScreenSpaceShadowmapTexture"], Is.EqualTo("_ScreenSpaceShadowmapTexture"));
                Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
                Assert.That(keywords.AtEnd, Is.EqualTo(ShadowKeywords.CascadesName));
            }
        }

        [Test]
        public void TheShaderHasAPassForEach()
        {
            string shader = File.ReadAllText(
                Path.Combine(FakeShader.PackageRoot(), "Shaders", "PenumbraDebugViews.shader"));
            Assert.That(shader, Does.Contain("\"" + DebugViewDraw.ShaderName + "\""));
            foreach (DebugView view in Views) Assert.That(shader, Does.Contain("Name \"" + view + "\""));
        }

        [Test]
        public void TheMaskIsShownWhereThereIsOne()
        {
            foreach (bool masked in new[] { true, false })
            {
                urp = new FakeUrp();
                feature.Settings.custom.mask = masked;
                feature.Settings.debugView = DebugView.PenumbraMask;
                urp.Render(new FakeScene(), feature);
                FakeDevice.DrawCall draw = urp.Device.Draws.Last();
                Assert.That(((Vector4)draw.Uniforms["_PenumbraDebugParams"]).x, Is.EqualTo(masked ? 1.0f : 0.0f));
                if (!masked) continue;
                FakeDevice.DrawCall mask = urp.Device.Draws.Single(call => call.Pass == "MaskBlurVertical");
                Assert.That(draw.Textures["_PenumbraMaskTexture"], Is.EqualTo(mask.Target));
                Assert.That(urp.Device.Draws.SkipWhile(call => call != mask).Skip(1).Select(call => call.Target),
                            Has.None.EqualTo(mask.Target), "overwritten before it is shown");
            }
        }

        /// <summary>Cell PCSS's kernels read no mask; the option is there for what is drawn in its place.</summary>
        [Test]
        public void CellPcssHasNoMaskAndItsFallbackHas()
        {
            feature.Settings.preset = QualityPreset.High;
            feature.Settings.debugView = DebugView.PenumbraMask;
            foreach (bool kernels in new[] { true, false })
            {
                SystemInfo.supportsComputeShaders = kernels;
                feature.Create();
                urp = new FakeUrp();
                urp.Render(new FakeScene(), feature);
                var shown = (Vector4)urp.Device.Draws.Last().Uniforms["_PenumbraDebugParams"];
                Assert.That(shown.x, Is.EqualTo(kernels ? 0.0f : 1.0f));
            }
        }

        [Test]
        public void AnOverlayCameraLeavesWhatItDoesNotSee()
        {
            feature.Settings.debugView = DebugView.Cascades;
            foreach (bool overlay in new[] { false, true })
            {
                urp.Render(new FakeScene { Overlay = overlay }, feature);
                Assert.That(((Vector4)urp.Device.Draws.Last().Uniforms["_PenumbraDebugParams"]).y,
                            Is.EqualTo(overlay ? 1.0f : 0.0f));
            }
        }

        [Test]
        public void AVolumeChoosesOneByPlace()
        {
            var volume = new PenumbraShadowsVolume();
            volume.debugView.overrideState = true;
            volume.debugView.value = DebugView.Cascades;
            volume.preset.overrideState = true;  // it has no preset of its own
            VolumeManager.instance.stack.Components[typeof(PenumbraShadowsVolume)] = volume;
            urp.Render(new FakeScene(), feature);
            Assert.That(Passes().Last(), Is.EqualTo("Cascades"));
            volume.debugView.overrideState = false;
            feature.Settings.debugView = DebugView.ShadowTexels;
            urp.Render(new FakeScene(), feature);
            Assert.That(Passes().Last(), Is.EqualTo("ShadowTexels"));
        }

        [Test]
        public void AReleasePlayerDrawsNone()
        {
            feature.Settings.debugView = DebugView.Cascades;
            Debug.isDebugBuild = false;
            urp.Render(new FakeScene(), feature);
            Assert.That(Passes().Last(), Is.EqualTo("Resolve"));
        }

        [Test]
        public void WithoutItsShaderTheFrameGoesOn()
        {
            feature.Dispose();
            Shader.Known.Remove(DebugViewDraw.ShaderName);
            feature = new PenumbraShadows();
            feature.Create();
            PresetFallback.Choose(feature.Settings, QualityPreset.High);
            feature.Settings.debugView = DebugView.Cascades;
            FrameKeywords keywords = urp.Render(new FakeScene(), feature);
            Assert.That(Passes().Last(), Is.EqualTo("Resolve"));
            Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
        }

        [Test]
        public void ACameraThatIsLeftToUrpOrHasNoPictureShowsNone()
        {
            feature.Settings.debugView = DebugView.Visibility;
            foreach (FakeScene scene in FakeScene.Every())
            {
                urp = new FakeUrp();
                urp.Render(scene, feature);
                bool drawn = Passes().Contains("Resolve");
                Assert.That(Passes().Contains("Visibility"), Is.EqualTo(drawn), scene.ToString());
            }
        }

        [Test]
        public void ThePictureIsATextureOrItsRowsAreAskedFor()
        {
            feature.Settings.debugView = DebugView.Visibility;
            var renderer = new RoomForPasses();
            RenderingData data = FakeUrp.Data(new FakeScene(), new Camera());
            feature.AddRenderPasses(renderer, ref data);
            ScriptableRenderPass last = renderer.Queue.OrderBy(pass => (int)pass.renderPassEvent).Last();
#if UNITY_6000_5_OR_NEWER
            Assert.That(last.renderPassEvent, Is.EqualTo(RenderPassEvent.AfterRenderingTransparents));
            Assert.That(last.requiresIntermediateTexture, Is.False, "it asks which way the rows run");
#elif UNITY_6000_0_OR_NEWER
            Assert.That(last.renderPassEvent, Is.EqualTo(RenderPassEvent.AfterRenderingTransparents));
            Assert.That(last.requiresIntermediateTexture);
#else
            Assert.That(last.renderPassEvent, Is.EqualTo(RenderPassEvent.BeforeRenderingPostProcessing));
            Assert.That(last.input, Is.EqualTo(ScriptableRenderPassInput.Color));
#endif
        }

        private sealed class RoomForPasses : ScriptableRenderer
        {
        }
    }
}
