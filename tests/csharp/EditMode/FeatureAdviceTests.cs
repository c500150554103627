using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;
using UnityEditor;

namespace Penumbra.Tests
{
    public sealed class FeatureAdviceTests
    {
        private static FeatureState Sound() => new FeatureState
        {
            shaderFound = true, mainLightShadows = true, deferred = true, settings = new PenumbraShadowsSettings(),
        };

        private static string[] Texts(FeatureState state, MessageType type) =>
            FeatureAdvice.For(state).Where(advice => advice.type == type).Select(advice => advice.text).ToArray();

        [Test]
        public void ASoundProjectNeedsNone() => Assert.That(FeatureAdvice.For(Sound()), Is.Empty);

        [Test]
        public void EachObstacleIsNamedWithTheWayOut()
        {
            FeatureState state = Sound();
            state.shaderFound = false;
            Assert.That(Texts(state, MessageType.Error).Single(), Does.Contain("Reimport"));
            state = Sound();
            state.compatibilityMode = true;
            Assert.That(Texts(state, MessageType.Error).Single(), Does.Contain("Compatibility Mode"));
            state = Sound();
            state.mainLightShadows = false;
            Assert.That(Texts(state, MessageType.Warning).Single(), Does.Contain("Cast Shadows"));
            state = Sound();
            state.urpScreenSpaceShadows = true;
            Assert.That(Texts(state, MessageType.Warning).Single(), Does.Contain("Remove it"));
            state = Sound();
            state.settings.noise = NoiseMode.PerFrame;
            Assert.That(Texts(state, MessageType.Info).Single(), Does.Contain("temporal"));
            state = Sound();
            state.settings.debugView = DebugView.Cascades;
            Assert.That(Texts(state, MessageType.Info).Single(), Does.Contain("debug view"));
            state = Sound();
            state.deferred = false;
            Assert.That(Texts(state, MessageType.Info).Single(), Does.Contain("Depth Priming"));
            state.depthPriming = true;
            Assert.That(FeatureAdvice.For(state), Is.Empty);
        }

        [Test]
        public void TheWorstComesFirst()
        {
            FeatureState state = default;
            state.settings = new PenumbraShadowsSettings { noise = NoiseMode.PerFrame };
            state.compatibilityMode = state.urpScreenSpaceShadows = true;
            Assert.That(FeatureAdvice.For(state).Select(advice => (int)advice.type), Is.Ordered.Descending);
        }
    }
}
