using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Tests
{
    /// <summary>What a pass brings along is in the feature's asset, and thereby in players.</summary>
    public sealed class PassAssetsTests
    {
        private sealed class Bringer : ShadowPass
        {
            internal Object Given;

            internal override int Order => 60;
            internal override string AssetPath => "Shaders/Reduction.compute";
            internal override void SetAsset(Object asset) => Given = asset;
            internal override bool IsNeeded(in ShadowOptions options) => Given != null;
            internal override void AddSteps(ShadowChain chain, in ShadowOptions options) { }
        }

        private const string Path = "Packages/com.penumbra.shadows/Shaders/Reduction.compute";

        private readonly Bringer bringer = new Bringer();
        private ShadowPass[] passes;

        [SetUp]
        public void SetUp() => passes = new ShadowPass[] { bringer, new ResolvePass() };

        [TearDown]
        public void TearDown() => AssetDatabase.Assets.Clear();

        [Test]
        public void TheEditorFindsItOnceAndThePlayerHasIt()
        {
            var kept = new PassAssets();
            Assert.That(kept.Find(passes), Is.False, "not imported yet");
            kept.Give(passes);
            Assert.That(bringer.IsNeeded(default), Is.False);

            var shader = new Shader();
            AssetDatabase.Assets[Path] = shader;
            Assert.That(kept.Find(passes));
            Assert.That(kept.Find(passes), Is.False, "is there already");
            AssetDatabase.Assets.Clear();  // as in a player
            kept.Give(passes);
            Assert.That(bringer.Given, Is.SameAs(shader));
        }

        [Test]
        public void AnAssetThatWentIsFoundAgain()
        {
            var kept = new PassAssets();
            var old = new Shader();
            AssetDatabase.Assets[Path] = old;
            kept.Find(passes);
            old.Destroyed = true;
            var shader = new Shader();
            AssetDatabase.Assets[Path] = shader;
            Assert.That(kept.Find(passes));
            kept.Give(passes);
            Assert.That(bringer.Given, Is.SameAs(shader));
        }
    }
}
