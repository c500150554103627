using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Tests
{
    /// <summary>URP's keywords are where URP has put them whenever anybody else looks, whatever happens in between.</summary>
    public sealed class KeywordTests
    {
        private PenumbraShadows feature;

        [SetUp]
        public void SetUp()
        {
            FakeShader.Install();
            feature = new PenumbraShadows();
            feature.Create();
            CommandBuffer.FailAt = -1;
        }

        [TearDown]
        public void TearDown()
        {
            CommandBuffer.FailAt = -1;
            feature.Dispose();
        }

        [Test]
        public void EveryCameraLeavesThemAsUrpDoes()
        {
            int ours = 0;
            foreach (FakeScene scene in FakeScene.Every())
            {
                FrameKeywords without = new FakeUrp().Render(scene);
                var urp = new FakeUrp();
                FrameKeywords with = urp.Render(scene, feature);
                Assert.That(with.AtTransparents, Is.EqualTo(without.AtTransparents), scene.ToString());
                Assert.That(with.AtEnd, Is.EqualTo(without.AtEnd), scene.ToString());
                bool switched = with.AtOpaques == ShadowKeywords.ScreenName;
                if (!switched) Assert.That(with.AtOpaques, Is.EqualTo(without.AtOpaques), scene.ToString());
                Assert.That(switched, Is.EqualTo(urp.Device.Draws.Count > 0), scene.ToString());
                if (switched) Assert.That(scene.UrpDraws, scene.ToString());
                ours += switched ? 1 : 0;
            }
            Assert.That(ours, Is.GreaterThan(20));
        }

        [Test]
        public void ACameraThatThrowsAnywhereDoesNotReachTheNext()
        {
            var scene = new FakeScene();
            FakeScene[] others = { new FakeScene { Cascades = 1 }, new FakeScene { Casters = false } };
            string[] expected = others.Select(other => new FakeUrp().Render(other).ToString()).ToArray();
            int points = 0;
            for (bool failed = true; failed; ++points)
            {
                var urp = new FakeUrp();
                CommandBuffer.FailAt = points;
                urp.Render(scene, feature);
                failed = CommandBuffer.FailAt < 0;
                CommandBuffer.FailAt = -1;
                // Of another renderer, which does not have the feature.
                string[] found = others.Select(other => urp.Render(other).ToString()).ToArray();
                Assert.That(found, Is.EqualTo(expected), $"after command {points}");
                FrameKeywords again = urp.Render(scene, feature);
                Assert.That(again.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName), $"after command {points}");
                Assert.That(again.AtEnd, Is.EqualTo(ShadowKeywords.CascadesName), $"after command {points}");
            }
            Assert.That(points, Is.GreaterThan(30), "commands of a frame, each of which failed once");
        }

        [Test]
        public void AStackOfCamerasSwitchesForEach()
        {
            var urp = new FakeUrp();
            foreach (int cascades in new[] { 4, 1, 2 })
            {
                FrameKeywords keywords = urp.Render(new FakeScene { Cascades = cascades }, feature);
                Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.ScreenName));
                Assert.That(keywords.AtEnd,
                            Is.EqualTo(cascades == 1 ? ShadowKeywords.MapName : ShadowKeywords.CascadesName));
            }
        }

        [Test]
        public void ADisposedFeatureWatchesNoCameras()
        {
            var context = new ScriptableRenderContext { Device = new FakeDevice() };
            ShadowKeywords.Global.Open(new CommandBuffer());
            feature.Dispose();
            RenderPipelineManager.BeginCamera(context, new Camera());
            Assert.That(ShadowKeywords.Global.IsOpen);
            feature.Create();
            RenderPipelineManager.BeginCamera(context, new Camera());
            Assert.That(ShadowKeywords.Global.IsOpen, Is.False);
        }
    }
}
