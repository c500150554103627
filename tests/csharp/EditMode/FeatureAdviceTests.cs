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
            shaderFound = true, debugShaderFound = true, mainLightShadows = true, deferred = true,
            settings = new PenumbraShadowsSettings(),
        };

        private static string[] Texts(FeatureState state, MessageType type) =>
            FeatureAdvice.For(state).Where(advice => advice.type == type).Select(advice => advice.text).ToArray();

        [Test]
        public void ASoundProjectNeedsNone() => Assert.That(FeatureAdvice.For(Sound()), Is.Empty);

        private delegate void Change(ref FeatureState state);

        private static FeatureState With(Change change)
        {
            FeatureState state = Sound();
            change(ref state);
            return state;
        }

        private static readonly (MessageType type, string[] said, Change change)[] Obstacles =
        {
            (MessageType.Error, new[] { "Reimport" }, (ref FeatureState s) => s.shaderFound = false),
            (MessageType.Error, new[] { "Compatibility Mode" }, (ref FeatureState s) => s.compatibilityMode = true),
            (MessageType.Error, new[] { "Depth Priming", "Disabled" },
             (ref FeatureState s) => (s.deferred, s.tileOnly, s.depthPriming) = (false, true, true)),
            (MessageType.Warning, new[] { "Cast Shadows" }, (ref FeatureState s) => s.mainLightShadows = false),
            (MessageType.Warning, new[] { "Remove it" }, (ref FeatureState s) => s.urpScreenSpaceShadows = true),
            (MessageType.Warning, new[] { "Add Component", "Terrain" },
             (ref FeatureState s) => s.missingGround = FarShadowGround.NoGround),
            (MessageType.Warning, new[] { "Water", "Prepass Layer Mask" },
             (ref FeatureState s) => s.layersWithoutDepth = 1 << 4),
            (MessageType.Warning, new[] { "The main light's Normal Bias is 1,", "Set it to 0" },
             (ref FeatureState s) => s.normalBias = 1.0f),
            (MessageType.Warning, new[] { "The main light's Normal Bias is 0.13," },
             (ref FeatureState s) => s.normalBias = 0.125f),
            (MessageType.Info, new[] { "temporal" }, (ref FeatureState s) => s.settings.noise = NoiseMode.PerFrame),
            (MessageType.Info, new[] { "debug view" }, (ref FeatureState s) => s.settings.debugView = DebugView.Cascades),
            (MessageType.Info, new[] { "Depth Priming" }, (ref FeatureState s) => s.deferred = false),
        };

        [Test]
        public void EachObstacleIsNamedWithTheWayOut()
        {
            foreach ((MessageType type, string[] said, Change change) in Obstacles)
                foreach (string words in said) Assert.That(Texts(With(change), type).Single(), Does.Contain(words));
            foreach (Change sound in new Change[] { (ref FeatureState s) => (s.deferred, s.depthPriming) = (false, true),
                                                    (ref FeatureState s) => (s.deferred, s.tileOnly) = (false, true) })
                Assert.That(FeatureAdvice.For(With(sound)), Is.Empty);
        }

        [Test]
        public void WhatDoesNotCompileComesFirst()
        {
            FeatureState state = Sound();
            state.shaderFound = false;
            state.shaderErrors = "ShaderLibrary/ScreenTiles/TileDecision.hlsl, line 12: undeclared identifier (D3D)";
            Assert.That(FeatureAdvice.For(state).First().type, Is.EqualTo(MessageType.Error));
            Assert.That(FeatureAdvice.For(state).First().text, Does.EndWith("\n" + state.shaderErrors));
        }

        /// <summary>Each field that the inspector shows counts.</summary>
        [TestCase(FarShadowMode.Off, false, 0)]
        [TestCase(FarShadowMode.Off, true, 1)]
        [TestCase(FarShadowMode.HeightMap, false, 3)]
        [TestCase(FarShadowMode.HorizonAngles, true, 1)]
        public void FarShadowsShowTheParametersOfTheirMode(FarShadowMode mode, bool clouds, int count)
        {
            string[] shown = FarShadowsFields.Parameters(mode, clouds);
            Assert.That(shown.Length, Is.EqualTo(count));
            Assert.That(shown.Except(typeof(FarShadowsParameters).GetFields().Select(field => field.Name)), Is.Empty);
            Assert.That(FarShadowsFields.CloudFields, Is.EquivalentTo(
                typeof(CloudParameters).GetFields().Where(field => !field.IsStatic).Select(field => field.Name)));
        }

        [Test]
        public void AMissingDebugShaderIsNamedWhenAViewIsChosen()
        {
            FeatureState state = Sound();
            state.debugShaderFound = false;
            Assert.That(FeatureAdvice.For(state), Is.Empty);
            state.settings.debugView = DebugView.Cascades;
            Advice advice = FeatureAdvice.For(state).Single();
            Assert.That(advice.type, Is.EqualTo(MessageType.Warning));
            Assert.That(advice.text, Does.Contain(DebugViewDraw.ShaderName));
        }

        private static string OfTheMask(FeatureState state)
        {
            state.settings.debugView = DebugView.PenumbraMask;
            return Texts(state, MessageType.Info).SingleOrDefault(text => text.StartsWith("The view Penumbra Mask "));
        }

        /// <summary>A preset is made to fall back; users who chose the technique may choose another.</summary>
        [TestCase(QualityPreset.Medium, MessageType.Info,
                  "The preset Medium draws Tiled PCSS where the device can. This one cannot: ")]
        [TestCase(QualityPreset.Custom, MessageType.Warning, "Tiled PCSS cannot run here as it is set: ")]
        public void WhatIsDrawnInsteadIsSaidAndWhy(QualityPreset preset, MessageType type, string before)
        {
            FeatureState state = Sound();
            state.settings.preset = preset;
            state.settings.custom.technique = ShadowTechnique.TiledPcss;
            state.asked = state.drawn = state.settings.Options();
            state.replaced = "this device has no kernels";
            state.drawn.technique = ShadowTechnique.PcssBounded;
            Assert.That(Texts(state, type),
                        Does.Contain(before + "this device has no kernels. Drawn instead: Bounded PCSS."));
        }

        [Test]
        public void WhyTheViewOfTheMaskIsYellowIsSaid()
        {
            const string yellow = "The view Penumbra Mask is yellow everywhere: ";
            FeatureState state = Sound();
            state.settings.preset = QualityPreset.High;
            Assert.That(OfTheMask(state), Is.EqualTo(yellow + "Tiled PCSS has no mask."));
            state.asked = state.drawn = state.settings.Options();
            state.replaced = "this device has no kernels";
            state.drawn.technique = ShadowTechnique.PcssBounded;
            Assert.That(OfTheMask(state), Is.EqualTo(yellow + "Mask is off."), "what is drawn instead can have one");
            state.drawn.mask = true;
            Assert.That(OfTheMask(state), Is.Null);
            state = Sound();
            PresetFallback.Choose(state.settings, QualityPreset.High);
            Assert.That(OfTheMask(state), Is.Null);
            state.settings.custom.mask = false;
            Assert.That(OfTheMask(state), Is.EqualTo(yellow + "Mask is off."));
            state.settings.custom.mask = true;
            state.settings.custom.angularDiameterDegrees = 0.0f;
            Assert.That(OfTheMask(state), Is.EqualTo(yellow + "PCSS at 0 degrees has no mask."));
            state.debugShaderFound = false;
            Assert.That(OfTheMask(state), Is.Null);
            state.debugShaderFound = true;
            state.settings.debugView = DebugView.Cascades;
            Assert.That(Texts(state, MessageType.Info), Has.None.StartsWith(yellow));
        }

        private static string[] Skipped(SkipReason reason)
        {
            FeatureState state = Sound();
            state.lastSkip = reason;
            Assert.That(FeatureAdvice.For(state).Select(advice => advice.type), Is.All.EqualTo(MessageType.Info));
            return Texts(state, MessageType.Info);
        }

        [Test]
        public void WhyTheLastCameraWasLeftIsSaidWithTheWayOut()
        {
            const string left = "The last camera was skipped and has URP's shadows: ";
            Assert.That(Skipped(SkipReason.SceneLightingOff).Single(), Does.StartWith(left).And.Contain("light bulb"));
            Assert.That(Skipped(SkipReason.ShadowsOff).Single(), Does.StartWith(left).And.Contain("Cast Shadows"));
            Assert.That(Skipped(SkipReason.NoMainLight).Single(), Does.StartWith(left).And.Contain("directional light"));
            Assert.That(Skipped(SkipReason.LightWithoutShadows).Single(),
                        Does.StartWith(left).And.Contain("Shadow Type"));
            Assert.That(Skipped(SkipReason.NoShadowDistance).Single(), Does.StartWith(left).And.Contain("Max Distance"));
            Assert.That(Skipped(SkipReason.NoCasters).Single(), Does.StartWith(left).And.Contain("renderers"));
            Assert.That(Skipped(SkipReason.InvalidCascade).Single(), Does.StartWith(left).And.Contain("Cascade Count"));
            Assert.That(Skipped(SkipReason.MetaQuest).Single(), Does.StartWith(left).And.Contain("build profile"));
        }

        [Test]
        public void AReasonWithoutWordsIsSaidByName()
        {
            var unknown = (SkipReason)1000;
            Assert.That(Skipped(unknown).Single(), Does.EndWith("shadows: " + unknown + "."));
        }

        [Test]
        public void WhatIsMeantOrSaidAlreadyIsNotSaid()
        {
            foreach (SkipReason reason in new[]
                     {
                         SkipReason.None, SkipReason.PreviewCamera, SkipReason.DepthOnlyCamera, SkipReason.SceneViewOff,
                         SkipReason.ReflectionProbesOff, SkipReason.MissingShader, SkipReason.CompatibilityMode,
                     })
                Assert.That(Skipped(reason), Is.Empty, reason.ToString());
            FeatureState state = Sound();
            state.mainLightShadows = false;
            state.lastSkip = SkipReason.ShadowsOff;
            Assert.That(FeatureAdvice.For(state).Single().type, Is.EqualTo(MessageType.Warning));
        }

        [Test]
        public void WhatOpenGlDrawsInsteadOfPcssIsSaid()
        {
            FeatureState state = Sound();
            state.openGl = true;
            Assert.That(FeatureAdvice.For(state), Is.Empty, "of a preset it is said once it has been drawn, with the reason");
            state.settings.preset = QualityPreset.Custom;
            state.settings.custom.technique = ShadowTechnique.Pcss;
            Assert.That(Texts(state, MessageType.Info).Single(), Does.Contain("Tent 7x7").And.Contain("Vulkan"));
            state.settings.custom.technique = ShadowTechnique.Tent5x5;
            Assert.That(FeatureAdvice.For(state), Is.Empty);
        }

        [Test]
        public void WhatIsDrawnInsteadIsSaidWithTheReason()
        {
            FeatureState state = Sound();
            state.settings.preset = QualityPreset.Custom;
            state.settings.custom.technique = ShadowTechnique.Vsm;
            state.asked = state.drawn = state.settings.Options();
            state.replaced = "this device cannot filter textures of R32G32_SFloat";
            state.drawn.mapFormat = MapFormat.Bits16;
            Assert.That(Texts(state, MessageType.Warning).Single(),
                        Does.StartWith("VSM ").And.Contain("R32G32_SFloat").And.Contain("16 bits"));
            state.drawn.technique = ShadowTechnique.Tent7x7;
            Assert.That(Texts(state, MessageType.Warning).Single(), Does.EndWith("Drawn instead: Tent 7x7."));
            state.asked.technique = ShadowTechnique.TiledPcss;
            state.drawn.technique = ShadowTechnique.PcssBounded;
            Assert.That(Texts(state, MessageType.Warning).Single(),
                        Does.StartWith("Tiled PCSS ").And.EndsWith("Drawn instead: Bounded PCSS."));
            state.openGl = true;
            Assert.That(Texts(state, MessageType.Warning).Single(), Does.EndWith("Drawn instead: Tent 7x7."),
                        "which shaders compute there in the place of PCSS");
            state.openGl = false;
            state.drawn = state.asked;
            state.drawn.conservativeMask = !state.asked.conservativeMask;
            Assert.That(Texts(state, MessageType.Warning).Single(), Does.Contain("mask of four"));
        }

        [TestCase(ShadowTechnique.Smrt, true)]
        [TestCase(ShadowTechnique.PcssGodot, true)]
        [TestCase(ShadowTechnique.PcssFilament, true)]
        [TestCase(ShadowTechnique.Pcss, false)]
        public void WhoBiasesReceiversItselfSaysSo(ShadowTechnique technique, bool biases)
        {
            FeatureState state = Sound();
            state.settings.preset = QualityPreset.Custom;
            state.settings.custom.technique = technique;
            Assert.That(Texts(state, MessageType.Info).Any(text => text.Contains("Depth and Normal 0")), Is.EqualTo(biases));
        }

        [Test]
        public void TheWorstComesFirst()
        {
            FeatureState state = default;
            state.settings = new PenumbraShadowsSettings { noise = NoiseMode.PerFrame, debugView = DebugView.Cascades };
            state.lastSkip = SkipReason.NoCasters;
            state.compatibilityMode = state.urpScreenSpaceShadows = state.tileOnly = state.depthPriming = true;
            Assert.That(FeatureAdvice.For(state).Select(advice => (int)advice.type), Is.Ordered.Descending);
        }
    }
}
