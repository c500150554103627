using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;

namespace Penumbra.Tests
{
    /// <summary>
    /// A debug view asks for no texture of the camera's own, which URP's Tile-Only Mode does not have, and is told
    /// which way the rows of the back buffer run.
    /// </summary>
    public sealed class BackBufferTests
    {
        [TearDown]
        public void TearDown() => RasterGraphContext.BackBuffer = TextureUVOrigin.BottomLeft;

        [TestCase(true, TextureUVOrigin.TopLeft, 1.0f)]
        [TestCase(true, TextureUVOrigin.BottomLeft, 0.0f)]
        [TestCase(false, TextureUVOrigin.TopLeft, 0.0f)]
        public void ItsRowsAreTold(bool toBackBuffer, TextureUVOrigin origin, float reversed)
        {
            FakeShader.Install();
            var feature = new PenumbraShadows();
            feature.Create();
            feature.Settings.debugView = DebugView.Visibility;
            RasterGraphContext.BackBuffer = origin;
            var urp = new FakeUrp();
            urp.Render(new FakeScene { ToBackBuffer = toBackBuffer }, feature);
            feature.Dispose();
            FakeDevice.DrawCall view = urp.Device.Draws.Last();
            Assert.That(view.Pass, Is.EqualTo("Visibility"));
            Assert.That(((Vector4)view.Uniforms["_PenumbraDebugParams"]).z, Is.EqualTo(reversed));
        }
    }
}
