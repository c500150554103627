using System.Text.RegularExpressions;
using UnityEditor.Rendering;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>URP's own feature, which is internal there, too.</summary>
    internal sealed class ScreenSpaceShadows : ScriptableRendererFeature
    {
        public override void Create() { }
        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData) { }
    }
}

namespace Penumbra.Tests
{
    /// <summary>
    /// A project with one obstacle: the inspector names it beside a button, which one undo takes back.
    /// </summary>
    public sealed class FeatureFixTests
    {
        private PenumbraShadows feature;
        private UniversalRendererData renderer;
        private UniversalRenderPipelineAsset asset;
        private UniversalAdditionalLightData lightData;
        private Light light;
        private FakeScene scene;

        [SetUp]
        public void AProjectWithoutObstacles()
        {
            FakeShader.Install();
            feature = ScriptableObject.CreateInstance<PenumbraShadows>();
            feature.Create();
            renderer = ScriptableObject.CreateInstance<UniversalRendererData>();
            renderer.renderingMode = RenderingMode.Deferred;
            renderer.rendererFeatures.Add(feature);
            AssetDatabase.Assets["Assets/Renderer.asset"] = renderer;
            AssetDatabase.Contained[feature] = renderer;
            asset = ScriptableObject.CreateInstance<UniversalRenderPipelineAsset>();
            asset.supportsMainLightShadows = true;
            asset.shadowDepthBias = 1.5f;
            GraphicsSettings.currentRenderPipeline = asset;
            var sun = new GameObject("Sun");
            light = sun.AddComponent<Light>();
            lightData = sun.AddComponent<UniversalAdditionalLightData>();
            lightData.usePipelineSettings = true;
            scene = new FakeScene { Sun = light };
        }

        [TearDown]
        public void TearDown()
        {
            feature.Dispose();
            AssetDatabase.Assets.Remove("Assets/Renderer.asset");
            AssetDatabase.Contained.Clear();
            GraphicsSettings.currentRenderPipeline = null;
            Terrain.activeTerrains = new Terrain[0];
        }

        private Advice[] Found()
        {
            new FakeUrp().Render(scene, feature);
            return FeatureAdvice.For(FeatureSurroundings.Of(feature)).ToArray();
        }

        /// <summary>With the button pressed the message is gone; with an undo it is back.</summary>
        private void AssertFixed(string words, int steps = 1)
        {
            Advice advice = Found().Single(one => one.text.Contains(words));
            Assert.That(advice.action, Is.Not.Null);
            Assert.That(advice.button, Is.EqualTo("Fix"));
            advice.action();
            Assert.That(Found().Select(one => one.text), Has.None.Contains(words));
            for (int step = 0; step < steps; ++step) Undo.PerformUndo();
            Assert.That(Found().Select(one => one.text), Has.One.Contains(words));
            advice.action();
        }

        [Test]
        public void ASoundProjectHasNone() => Assert.That(Found(), Is.Empty);

        [Test]
        public void TheNormalBiasOfTheAssetIsReplacedForTheMainLightAlone()
        {
            asset.shadowNormalBias = 1.25f;
            AssertFixed("Normal Bias is 1.25");
            Assert.That(lightData.usePipelineSettings, Is.False);
            Assert.That((light.shadowBias, light.shadowNormalBias), Is.EqualTo((1.5f, 0.0f)));
            Assert.That((asset.shadowDepthBias, asset.shadowNormalBias), Is.EqualTo((1.5f, 1.25f)));
            Assert.That(PrefabUtility.Recorded, Is.SupersetOf(new UnityEngine.Object[] { light, lightData }));
        }

        [Test]
        public void TheLightsOwnNormalBiasCountsWhereItHasOne()
        {
            lightData.usePipelineSettings = false;
            asset.shadowNormalBias = 1.0f;
            Assert.That(Found(), Is.Empty);
            light.shadowBias = 0.75f;
            light.shadowNormalBias = 0.5f;
            AssertFixed("Normal Bias is 0.5");
            Assert.That(light.shadowBias, Is.EqualTo(0.75f));
        }

        [Test]
        public void ALightWithoutUrpsComponentGetsIt()
        {
            light.Owner.Components.Remove(lightData);
            asset.shadowNormalBias = 1.0f;
            AssertFixed("Normal Bias is 1", steps: 2);
            Assert.That(light.Owner.GetComponent<UniversalAdditionalLightData>().usePipelineSettings, Is.False);
        }

        [Test]
        public void ATechniqueThatBiasesReceiversGetsNeitherBias()
        {
            feature.Settings.preset = QualityPreset.Custom;
            feature.Settings.custom.technique = ShadowTechnique.Smrt;
            asset.shadowNormalBias = 1.0f;
            Advice advice = Found().Single(one => one.text.Contains("Depth and Normal 0"));
            Assert.That(Found().Select(one => one.text), Has.None.Contains("Normal Bias is"));
            advice.action();
            Assert.That((light.shadowBias, light.shadowNormalBias), Is.EqualTo((0.0f, 0.0f)));
            Assert.That(Found().Single(one => one.text.Contains("Depth and Normal 0")).action, Is.Null);
        }

        [Test]
        public void APreviewsLightIsNotTheMainLight()
        {
            asset.shadowNormalBias = 1.0f;
            Found();
            scene.Sun = null;
            scene.Camera = CameraType.Preview;
            Found();
            Assert.That(feature.MainLight, Is.SameAs(light));
            scene.Camera = CameraType.Game;
            scene.MainLight = false;
            Assert.That(Found().Select(one => one.text), Has.None.Contains("Normal Bias is"));
        }

        [Test]
        public void CastShadowsOfTheAsset()
        {
            asset.supportsMainLightShadows = false;
            AssertFixed("Cast Shadows of the main light is off");
            Assert.That(asset.supportsMainLightShadows);
        }

        [Test]
        public void TheShadowTypeOfTheLight()
        {
            scene.Shadows = LightShadows.None;
            Advice advice = Found().Single(one => one.text.Contains("Shadow Type"));
            advice.action();
            Assert.That(light.shadows, Is.EqualTo(LightShadows.Soft));
            Undo.PerformUndo();
            Assert.That(light.shadows, Is.EqualTo(LightShadows.None));
        }

        [Test]
        public void UrpsOwnScreenSpaceShadowsAreSwitchedOff()
        {
            var urps = ScriptableObject.CreateInstance<ScreenSpaceShadows>();
            renderer.rendererFeatures.Add(urps);
            AssertFixed("URP's Screen Space Shadows feature");
            Assert.That(urps.isActive, Is.False);
            Assert.That(feature.isActive);
        }

#if UNITY_6000_5_OR_NEWER
        [Test]
        public void LayersAreAddedToThePrepass()
        {
            var serialized = new SerializedObject(renderer);
            serialized.FindProperty("m_PrepassLayerMask").intValue = ~16;
            serialized.ApplyModifiedProperties();
            AssertFixed("Prepass Layer Mask");
            Assert.That(PrepassLayers.LeftOut(serialized), Is.Zero);
        }

        [Test]
        public void DepthPrimingGivesWayToTileOnlyMode()
        {
            renderer.tileOnlyMode = true;
            renderer.depthPrimingMode = DepthPrimingMode.Auto;
            AssertFixed("Depth Priming are on");
            Assert.That(renderer.depthPrimingMode, Is.EqualTo(DepthPrimingMode.Disabled));
        }
#endif

        /// <summary>
        /// Depth priming makes surfaces vanish whose shader has no matching depth pass, so it is a hint, not a fix.
        /// </summary>
        [Test]
        public void DepthPrimingIsNotSwitchedOnByAButton()
        {
            renderer.renderingMode = RenderingMode.Forward;
            Assert.That(Found().Single(one => one.text.Contains("Depth Priming")).action, Is.Null);
        }

        [Test]
        public void TheOnlyTerrainBecomesTheFarShadowGround()
        {
            feature.Settings.farShadows.mode = FarShadowMode.HeightMap;
            Assert.That(Ground().action, Is.Null, "no Terrain");
            Terrain one = new GameObject("One").AddComponent<Terrain>(), two = new GameObject("Two").AddComponent<Terrain>();
            Terrain.activeTerrains = new[] { one, two };
            Assert.That(Ground().action, Is.Null, "two");
            Terrain.activeTerrains = new[] { two };
            Ground().action();
            Assert.That(two.Owner.GetComponent<FarShadowGround>(), Is.Not.Null);
            Assert.That(Ground().action, Is.Null, "one that is disabled");
            Undo.PerformUndo();
            Assert.That(two.Owner.GetComponent<FarShadowGround>(), Is.Null);
        }

        private Advice Ground() => Found().Single(one => one.text.Contains("no Far Shadow Ground is enabled"));

#if !UNITY_6000_5_OR_NEWER && UNITY_6000_0_OR_NEWER
        /// <summary>The mode is a switch of the whole project, which URP has a page for.</summary>
        [Test]
        public void CompatibilityModeOpensItsPage()
        {
            GraphicsSettings.Settings[typeof(RenderGraphSettings)] =
                new RenderGraphSettings { enableRenderCompatibilityMode = true };
            Advice advice = Found().Single(one => one.text.Contains("Compatibility Mode"));
            GraphicsSettings.Settings.Clear();
            Assert.That(advice.button, Is.EqualTo("Open"));
            advice.action();
            Assert.That(SettingsService.Opened, Is.EqualTo("Project/Graphics"));
        }
#endif

        [Test]
        public void TheFirstStepsNameEveryButton()
        {
            var words = new Dictionary<string, string>
            {
                [nameof(FeatureFixes.mainLightShadows)] = "*Cast Shadows* in the URP asset",
                [nameof(FeatureFixes.lightShadows)] = "light's *Shadow Type*",
                [nameof(FeatureFixes.lightBias)] = "**Normal Bias to 0**",
                [nameof(FeatureFixes.urpScreenSpaceShadows)] = "URP's own *Screen Space Shadows*",
                [nameof(FeatureFixes.prepassLayers)] = "layers outside the prepass",
                [nameof(FeatureFixes.depthPriming)] = "*Depth Priming* in Tile-Only Mode",
                [nameof(FeatureFixes.ground)] = "*Penumbra Far Shadow Ground*",
            };
            string page = File.ReadAllText(Path.Combine(FakeShader.PackageRoot(), "Documentation~/installation.md"));
            string steps = Regex.Match(page, "## First steps\n(.*?)\n## ", RegexOptions.Singleline).Groups[1].Value;
            steps = Regex.Replace(steps, @"\s+", " ");
            Assert.That(steps, Does.Contain("a button *Fix*").And.Contain("*Open* leads to"));
            foreach (System.Reflection.FieldInfo fix in typeof(FeatureFixes).GetFields(
                         System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic))
                Assert.That(steps, Does.Contain(words[fix.Name]), fix.Name);
        }

        [Test]
        public void OnlyWhatCanBeActedOnHasAButton()
        {
            EditorGUILayout.Boxes.Clear();
            CoreEditorUtils.Boxes.Clear();
            bool pressed = false;
            AdviceBox.Show(new[]
            {
                new Advice(MessageType.Info, "told"), new Advice(MessageType.Warning, "offered", () => pressed = true, "Do"),
            });
            Assert.That(EditorGUILayout.Boxes, Is.EqualTo(new[] { "told" }));
            Assert.That(CoreEditorUtils.Boxes.Single().message, Is.EqualTo("offered"));
            Assert.That(CoreEditorUtils.Boxes.Single().button, Is.EqualTo("Do"));
            CoreEditorUtils.Boxes.Single().action();
            Assert.That(pressed);
        }
    }
}
