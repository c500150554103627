using UnityEngine.Rendering.RenderGraphModule;

namespace Penumbra.Tests;

/// <summary>
/// A debug view asks for no texture of the camera's own, which URP's Tile-Only Mode does not have, and is told
/// which way the rows of the back buffer run.
/// </summary>
public sealed class BackBufferTests : FeatureTests
{
    [TearDown]
    public void TearDown() => RasterGraphContext.BackBuffer = TextureUVOrigin.BottomLeft;

    [TestCase(true, TextureUVOrigin.TopLeft, 1.0f)]
    [TestCase(true, TextureUVOrigin.BottomLeft, 0.0f)]
    [TestCase(false, TextureUVOrigin.TopLeft, 0.0f)]
    public void ItsRowsAreTold(bool toBackBuffer, TextureUVOrigin origin, float reversed)
    {
        feature.Settings.debugView = DebugView.Visibility;
        RasterGraphContext.BackBuffer = origin;
        Assert.That(Render(new FakeScene { ToBackBuffer = toBackBuffer }).Last(), Is.EqualTo("Visibility"));
        Assert.That(Vector(urp.Device.Draws.Last(), "_PenumbraDebugParams").z, Is.EqualTo(reversed));
    }
}
