using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Tests
{
    /// <summary>
    /// Runs whole frames, from AddRenderPasses to the last pass that is enqueued: once the chains and textures are
    /// there, none leaves the collector anything, nor makes a texture.
    /// </summary>
    public sealed class FrameAllocationTests
    {
        private PenumbraShadows feature;

        [SetUp]
        public void SetUp()
        {
            FakeShader.Install();
            feature = new PenumbraShadows();
            feature.Settings.preset = QualityPreset.Custom;
        }

        [TearDown]
        public void TearDown()
        {
            CommandBuffer.Silent = false;
            feature.Dispose();
            AddedTechniques.Remove();
            Time.frameCount = 0;
        }

        private static ShadowOptions Screen(QualityPreset preset) => PresetFallback.Options(preset);

        // Each camera has its options, as Volumes give them. The chains have other lengths, and textures that are owned
        // or lent.
        private static readonly object[] Turns =
        {
            new object[] { (Action)(() => { }), new[] { Screen(QualityPreset.Low) } },
            new object[] { (Action)(() => { }), new[] { Screen(QualityPreset.Low), Screen(QualityPreset.Ultra) } },
            new object[]
            {
                (Action)(() => { }),
                new[] { ShadowPresets.Options(QualityPreset.Low), ShadowPresets.Options(QualityPreset.Ultra) },
            },
            new object[]
            {
                (Action)(() => AddedTechniques.AddMeans()), new[] { AddedTechniques.Options(), Screen(QualityPreset.High) },
            },
            new object[]
            {
                (Action)(() =>
                {
                    AddedTechniques.AddMeans();
                    AddedTechniques.Use(CasterTests.OfMap);
                }),
                new[] { AddedTechniques.Options(), Screen(QualityPreset.High) },
            },
            new object[]
            {
                (Action)(() => AddedTechniques.AddBlocks()), new[] { AddedTechniques.Options(), Screen(QualityPreset.High) },
            },
        };

        [Test]
        public void AnAllocationIsSeen()
        {
            byte[] kept = null;
            Assert.That(Allocations.Of(() => kept = new byte[1]), Is.Positive);
            Assert.That(kept, Has.Length.EqualTo(1));
        }

        [TestCaseSource(nameof(Turns))]
        public void FramesAllocateNothing(Action technique, object options)
        {
            technique();
            feature.Create();
            var turns = (ShadowOptions[])options;
            var cameras = new SteadyCamera[turns.Length];
            for (int i = 0; i < cameras.Length; ++i) cameras[i] = new SteadyCamera(new FakeScene());
            CommandBuffer.Silent = true;
            void Frames(int count)
            {
                for (int frame = 0; frame < count; ++frame, ++Time.frameCount)
                    for (int i = 0; i < cameras.Length; ++i)
                    {
                        feature.Settings.custom = turns[i];
                        cameras[i].Render(feature);
                    }
            }

            Frames(3);
            Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
            Assert.That(Allocations.Of(() => Frames(1000)), Is.Zero);
        }
    }
}
