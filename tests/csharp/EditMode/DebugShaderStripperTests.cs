using NUnit.Framework;
using Penumbra.Editor;
using UnityEditor;

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

        /// <summary>A build that a script starts has its options from the script.</summary>
        [Test]
        public void APlayersOwnOptionsSayWhichItIs()
        {
            bool window = EditorUserBuildSettings.development;
            try
            {
                PlayerBuild.Begin(BuildOptions.Development);
                Assert.That(PlayerBuild.IsDevelopment);
                PlayerBuild.Begin(BuildOptions.None);
                Assert.That(PlayerBuild.IsDevelopment, Is.False);
            }
            finally
            {
                PlayerBuild.End();
            }
            Assert.That(PlayerBuild.IsDevelopment, Is.EqualTo(window));
        }
    }
}
