using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Tests
{
    /// <summary>
    /// The example of Documentation~/pipelines.md is this file's, so it compiles and does what it says.
    /// </summary>
    [TestFixture]
    public class DocumentationTests
    {
        private static ShadowUniforms used;
        private static Matrix4x4 answered;

        private static void Example(Matrix4x4 worldToShadow, Matrix4x4 view, Matrix4x4 gpuProjection)
        {
            // example:begin
            var parameters = SoftShadowParameters.Default;
            parameters.AngularDiameterDegrees = 2.0f;
            var layout = new AtlasLayout(2048, 4);
            var uniforms = new ShadowUniforms(parameters, layout, frameIndex: 0);
            var scales = new CascadeScales(worldToShadow, layout, parameters.AngularDiameterDegrees);
            if (!scales.IsMapped) return; // URP left this cascade without a map
            var conventions = new ScreenConventions(uvStartsAtTop: true, depthIsZeroToOne: true);
            if (!ScreenToWorld.TryGet(view, gpuProjection, conventions, out var screenToWorld)) return;
            // example:end
            used = uniforms;
            answered = screenToWorld;
        }

        private static string[] ExampleLines()
        {
            var here = Path.Combine(TestContext.CurrentContext.TestDirectory, "DocumentationTests.cs");
            return File.ReadAllLines(here).Select(line => line.Trim())
                .SkipWhile(line => line != "// example:begin").Skip(1)
                .TakeWhile(line => line != "// example:end").ToArray();
        }

        [Test]
        public void ThePagesExampleIsTheCompiledOne()
        {
            var page = File.ReadAllLines(Path.Combine(TestContext.CurrentContext.TestDirectory, "pipelines.md"));
            var example = page.SkipWhile(line => line != "```csharp").Skip(1).TakeWhile(line => line != "```");
            Assert.That(ExampleLines(), Is.Not.Empty);
            Assert.That(example, Is.EqualTo(ExampleLines()));
        }

        [Test]
        public void TheExampleComesToItsEnd()
        {
            Example(new LightFrustum().WorldToShadow, Matrix4x4.identity, new LightFrustum().WorldToShadow);
            Assert.That(used.MainLightParams.y, Is.EqualTo(AngularDiameter.TanHalf(2.0f)));
            Assert.That(answered, Is.Not.EqualTo(Matrix4x4.identity));
        }
    }
}
