using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// The lists that the pipeline records for a camera: the tests say where each is drawn, and with which uniforms.
    /// </summary>
    internal sealed class SoftShadowPipelineTests
    {
        private FakeDevice device;
        private SunShadowSettings settings;

        [SetUp]
        public void SetUp()
        {
            device = new FakeDevice();
            settings = new SunShadowSettings { cascades = 3 };
            CullingResults.Next = new CullingResults { HasCasters = true };
            CullingResults.Lights = new[] { Lamp(LightType.Point, LightShadows.Soft), Sunlight(LightShadows.Soft) };
            CullingResults.Missing.Clear();
        }

        private static VisibleLight Lamp(LightType type, LightShadows shadows) =>
            new VisibleLight { Source = new Light { type = type, shadows = shadows } };

        private static VisibleLight Sunlight(LightShadows shadows)
        {
            VisibleLight visible = Lamp(LightType.Directional, shadows);
            visible.Source.intensity = 3.0f;
            visible.Source.color = new Color(1.0f, 0.5f, 0.0f, 1.0f);
            visible.Source.transform.forward = new Vector3(0.0f, -1.0f, 0.0f);
            return visible;
        }

        private void Render()
        {
            var pipeline = new SoftShadowPipeline(settings);
            pipeline.RenderNow(new ScriptableRenderContext { Device = device }, new Camera());
            pipeline.DisposeNow();
        }

        private string[] Draws => device.Draws.Select(draw => draw.Pass + " -> " + draw.Target).ToArray();

        private Vector4 Uniform(string name) => (Vector4)device.Draws.Last().Uniforms[name];

        [Test]
        public void EveryCascadeIsDrawnIntoTheMapAndThenTheScene()
        {
            Render();
            Assert.That(Draws, Is.EqualTo(new[]
            {
                "cascade 0 -> _SunShadowMap", "cascade 1 -> _SunShadowMap", "cascade 2 -> _SunShadowMap",
                "PenumbraSampleLit -> camera", "sky -> camera",
            }));
            Assert.That(Uniform("_SunCascades").x, Is.EqualTo(3.0f));
            Assert.That(device.Draws.Last().Textures["_SunShadowMap"], Is.EqualTo("2048 x 2048"));
        }

        [Test]
        public void EachCascadeHasItsTileAndItsBias()
        {
            Render();
            Assert.That(device.Draws.Take(3).Select(draw => draw.Viewport.Value.x),
                        Is.EqualTo(new[] { 0.0f, 1024.0f, 0.0f }));
            // The squares are 2, 4 and 6 m wide in 1024 texels, and the bias is one texel.
            Assert.That(device.Draws.Take(3).Select(draw => ((Vector4)draw.Uniforms["_SunCasterBias"]).x * 1024.0f),
                        Is.EqualTo(new[] { -2.0f, -4.0f, -6.0f }).Within(1e-5f));
        }

        [Test]
        public void TheMapIsReleasedAfterTheLastDraw()
        {
            Render();
            Assert.That(device.Draws.Select(draw => draw.Textures["_SunShadowMap"]), Has.All.EqualTo("2048 x 2048"));
            Assert.That(device.Textures["_SunShadowMap"], Is.Null);
        }

        [Test]
        public void TheSunIsLinearAndPointsTowardsTheLight()
        {
            Render();
            Assert.That(Uniform("_SunDirection"), Is.EqualTo(new Vector4(0.0f, 1.0f, 0.0f, 0.0f)));
            Vector4 color = Uniform("_SunColor");
            Assert.That(color.x, Is.EqualTo(3.0f).Within(1e-5f));
            Assert.That(color.y, Is.EqualTo(3.0f * 0.2140f).Within(1e-3f));
            Assert.That(color.z, Is.Zero);
        }

        private static readonly string[] withoutShadows = { "no sun", "hard light off", "no casters" };

        [Test]
        public void WithoutAShadowNothingIsDrawnIntoAMapOfOneTexel([ValueSource(nameof(withoutShadows))] string reason)
        {
            if (reason == "no sun") CullingResults.Lights = new VisibleLight[0];
            if (reason == "hard light off") CullingResults.Lights = new[] { Sunlight(LightShadows.None) };
            if (reason == "no casters") CullingResults.Next = new CullingResults { HasCasters = false };
            Render();
            Assert.That(Draws, Is.EqualTo(new[] { "PenumbraSampleLit -> camera", "sky -> camera" }));
            Assert.That(Uniform("_SunCascades").x, Is.Zero);
            Assert.That(device.Draws.Last().Textures["_SunShadowMap"], Is.EqualTo("1 x 1"));
        }

        [Test]
        public void ACascadeWithoutMatricesIsNotDrawnAndHoldsNoPoint()
        {
            CullingResults.Missing.Add(1);
            Render();
            Assert.That(Draws.Where(draw => draw.StartsWith("cascade")),
                        Is.EqualTo(new[] { "cascade 0 -> _SunShadowMap", "cascade 2 -> _SunShadowMap" }));
            var spheres = (Vector4[])device.Draws.Last().Uniforms["_SunSpheres"];
            Assert.That(spheres.Select(sphere => sphere.w), Is.EqualTo(new[] { 1.0f, 0.0f, 9.0f, 0.0f }));
        }

#if UNITY_6000_0_OR_NEWER
        [Test]
        public void CastersAreCulledForTheSunsCascadesAlone()
        {
            Render();
            ShadowCastersCullingInfos culled = ScriptableRenderContext.Culled;
            Assert.That(culled.splitBuffer.Length, Is.EqualTo(3));
            Assert.That(culled.splitBuffer[2].cullingSphere.w, Is.EqualTo(3.0f));
            Assert.That(culled.splitBuffer[2].shadowCascadeBlendCullingFactor, Is.EqualTo(1.0f));
            Assert.That(culled.perLightInfos.Length, Is.EqualTo(2));
            Assert.That(culled.perLightInfos[0].splitRange.length, Is.Zero);
            Assert.That(culled.perLightInfos[1].splitRange.length, Is.EqualTo(3));
            Assert.That(culled.perLightInfos[1].projectionType, Is.EqualTo(BatchCullingProjectionType.Orthographic));
        }
#endif
    }
}
