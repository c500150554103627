using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Samples.ForwardShader
{
    /// <summary>Each camera of URP finds the uniforms that its asset asks for; other pipelines' cameras change none.
    /// </summary>
    internal sealed class ForwardShadowUniformsTests
    {
        private ForwardShadowUniforms component;

        [SetUp]
        public void SetUp()
        {
            Shader.Globals.Clear();
            component = new GameObject("uniforms").AddComponent<ForwardShadowUniforms>();
            Call("OnEnable");
        }

        [TearDown]
        public void TearDown()
        {
            Call("OnDisable");
            GraphicsSettings.currentRenderPipeline = null;
        }

        // The engine calls methods in this way, whatever their accessibility.
        private void Call(string message) =>
            typeof(ForwardShadowUniforms).GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic)
                                         .Invoke(component, null);

        private static void BeginCamera() => RenderPipelineManager.BeginCamera(default, new Camera());

        [Test]
        public void UniformsAreThoseOfTheAssetsLayout()
        {
            GraphicsSettings.currentRenderPipeline =
                new UniversalRenderPipelineAsset { mainLightShadowmapResolution = 2048, shadowCascadeCount = 2 };
            BeginCamera();
            Assert.That(Shader.Globals["_PenumbraMainLightAtlasTexelSize"],
                        Is.EqualTo(new Vector4(1.0f / 2048.0f, 1.0f / 1024.0f, 2048.0f, 1024.0f)));
            var expected = new ShadowUniforms(SoftShadowParameters.Default, new AtlasLayout(2048, 2), 0);
            Assert.That(Shader.Globals["_PenumbraMainLightParams"], Is.EqualTo(expected.MainLightParams));
            Assert.That(Shader.Globals["_PenumbraPcssAngularParameters0"], Is.EqualTo(expected.PcssAngular.Vector0));
            Assert.That(Shader.Globals["_PenumbraPcssAngularParameters1"], Is.EqualTo(expected.PcssAngular.Vector1));
            Assert.That(Shader.Globals["_PenumbraPcssClassicParameters0"], Is.EqualTo(expected.PcssClassic.Vector0));
            Assert.That(Shader.Globals["_PenumbraPcssHdrpParameters0"], Is.EqualTo(expected.PcssHdrp.Vector0));
            Assert.That(Shader.Globals["_PenumbraPcssHdrpParameters1"], Is.EqualTo(expected.PcssHdrp.Vector1));
            Assert.That(Shader.Globals["_PenumbraPcssSpotParameters0"],
                        Is.EqualTo(new Vector4(24.0f, 16.0f, 1.25f, 100.0f)));
            Assert.That(expected.MainLightParams.x, Is.EqualTo(2.0f));
            Assert.That(expected.PcssAngular.Vector0.x, Is.EqualTo(24.0f));
        }

        [Test]
        public void OtherPipelinesAndADisabledComponentChangeNothing()
        {
            BeginCamera();
            Assert.That(Shader.Globals, Is.Empty);
            GraphicsSettings.currentRenderPipeline = new UniversalRenderPipelineAsset();
            Call("OnDisable");
            BeginCamera();
            Assert.That(Shader.Globals, Is.Empty);
            Call("OnEnable");
            BeginCamera();
            Assert.That(Shader.Globals.Count, Is.EqualTo(8));
        }
    }
}
