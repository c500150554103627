using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Tests
{
    public sealed class FrameGateTests
    {
        private static ShadowSource Source() => new ShadowSource
        {
            cameraType = CameraType.Game, supported = true, mainLightIndex = 0, lightShadows = LightShadows.Hard,
            distanceMetres = 50.0f, hasCasters = true, hasCascades = true, cascadeCount = 4, mapWidth = 2048,
        };

        private static SkipReason Reason(ShadowSource source) =>
            FrameGate.Reason(source, new PenumbraShadowsSettings()) is var reason && reason != SkipReason.None
                ? reason : FrameGate.WithoutMap(source);

        private delegate void Change(ref ShadowSource source);

        private static SkipReason With(Change change)
        {
            ShadowSource source = Source();
            change(ref source);
            return Reason(source);
        }

        [Test]
        public void AFrameWithAShadowIsOurs() => Assert.That(Reason(Source()), Is.EqualTo(SkipReason.None));

        [Test]
        public void EveryReasonIsNamed()
        {
            Assert.That(With((ref ShadowSource s) => s.cameraType = CameraType.Preview),
                        Is.EqualTo(SkipReason.PreviewCamera));
            Assert.That(With((ref ShadowSource s) => s.depthOnly = true), Is.EqualTo(SkipReason.DepthOnlyCamera));
            Assert.That(With((ref ShadowSource s) => s.metaQuest = true), Is.EqualTo(SkipReason.MetaQuest));
            Assert.That(With((ref ShadowSource s) => s.sceneLightingOff = true),
                        Is.EqualTo(SkipReason.SceneLightingOff));
            Assert.That(With((ref ShadowSource s) => s.supported = false), Is.EqualTo(SkipReason.ShadowsOff));
            Assert.That(With((ref ShadowSource s) => s.mainLightIndex = -1), Is.EqualTo(SkipReason.NoMainLight));
            Assert.That(With((ref ShadowSource s) => s.lightShadows = LightShadows.None),
                        Is.EqualTo(SkipReason.LightWithoutShadows));
            Assert.That(With((ref ShadowSource s) => s.distanceMetres = 0.0f), Is.EqualTo(SkipReason.NoShadowDistance));
            Assert.That(With((ref ShadowSource s) => s.distanceMetres = float.NaN),
                        Is.EqualTo(SkipReason.NoShadowDistance));
            Assert.That(With((ref ShadowSource s) => s.hasCasters = false), Is.EqualTo(SkipReason.NoCasters));
            Assert.That(With((ref ShadowSource s) => s.hasCascades = false), Is.EqualTo(SkipReason.InvalidCascade));
        }

        [TestCase(CameraType.SceneView)]
        [TestCase(CameraType.Reflection)]
        public void SettingsDecideForWhomItIsDrawn(CameraType camera)
        {
            ShadowSource source = Source();
            source.cameraType = camera;
            foreach (bool wanted in new[] { false, true })
            {
                var settings = new PenumbraShadowsSettings { sceneView = wanted, reflectionProbes = wanted };
                Assert.That(FrameGate.Reason(source, settings) == SkipReason.None, Is.EqualTo(wanted));
            }
        }
    }
}
