using NUnit.Framework;
using Penumbra.Editor;

namespace Penumbra.Tests
{
    public sealed class DebugShaderStripperTests
    {
        [Test]
        public void OnlyDevelopmentBuildsHaveTheViews()
        {
            Assert.That(DebugShaderStripper.Removes(DebugViewDraw.ShaderName, development: false));
            Assert.That(DebugShaderStripper.Removes(DebugViewDraw.ShaderName, development: true), Is.False);
            Assert.That(DebugShaderStripper.Removes(PenumbraShadows.ShaderName, development: false), Is.False);
        }
    }
}
