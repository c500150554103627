using NUnit.Framework;
using Penumbra.Editor;

namespace Penumbra.Tests
{
    public sealed class ReceiverPragmaTests
    {
        [TestCase("#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE", ReceiverKind.LacksScreen)]
        [TestCase("#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN",
                  ReceiverKind.Complete)]
        [TestCase("\t#pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS // hard", ReceiverKind.LacksScreen)]
        [TestCase("#pragma shader_feature_local _MAIN_LIGHT_SHADOWS_CASCADE", ReceiverKind.LacksScreen)]
        [TestCase("// #pragma multi_compile _ _MAIN_LIGHT_SHADOWS", ReceiverKind.None)]
        [TestCase("/* a\n#pragma multi_compile _ _MAIN_LIGHT_SHADOWS\n*/", ReceiverKind.None)]
        [TestCase("/* a */ #pragma multi_compile _ _MAIN_LIGHT_SHADOWS", ReceiverKind.LacksScreen)]
        [TestCase("#pragma vertex _MAIN_LIGHT_SHADOWS", ReceiverKind.None)]
        [TestCase("#if defined(_MAIN_LIGHT_SHADOWS)", ReceiverKind.None)]
        [TestCase("#pragma multi_compile _ _MAIN_LIGHT_SHADOWS_SCREEN", ReceiverKind.None)]
        [TestCase("#pragma multi_compile _ _MAIN_LIGHT_SHADOWS_MINE", ReceiverKind.None)]
        [TestCase("", ReceiverKind.None)]
        public void KindIsReadFromPragmas(string text, ReceiverKind kind) =>
            Assert.That(ReceiverPragma.KindOf(text), Is.EqualTo(kind));

        [Test]
        public void OneLackingPassIsEnough() =>
            Assert.That(ReceiverPragma.KindOf("#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_SCREEN\n" +
                                              "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS"),
                        Is.EqualTo(ReceiverKind.LacksScreen));

        [Test]
        public void TheKeywordGoesBehindThePragmasWordsAndNothingElseChanges()
        {
            const string before = "Shader \"A\" {\r\n  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS  // soft\r\n" +
                                  "  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN\r\n" +
                                  "  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS";
            const string after = "Shader \"A\" {\r\n  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS" +
                                 " _MAIN_LIGHT_SHADOWS_SCREEN  // soft\r\n" +
                                 "  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN\r\n" +
                                 "  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_SCREEN";
            Assert.That(ReceiverPragma.WithScreen(before), Is.EqualTo(after));
            Assert.That(ReceiverPragma.KindOf(after), Is.EqualTo(ReceiverKind.Complete));
            Assert.That(ReceiverPragma.WithScreen(after), Is.EqualTo(after));
        }

        [TestCase("Assets/Water.shader", ReceiverFix.AddKeyword)]
        [TestCase("Packages/com.other.water/Water.shader", ReceiverFix.CopyToProject)]
        [TestCase("Assets/Water.shadergraph", ReceiverFix.Reimport)]
        public void EachPlaceHasItsFix(string path, ReceiverFix fix) =>
            Assert.That(ReceiverReport.FixFor(path), Is.EqualTo(fix));

        [Test]
        public void ThePipelinesOwnAreNotLookedAt()
        {
            Assert.That(ReceiverReport.IsPipelines("Packages/com.unity.render-pipelines.universal/Shaders/Lit.shader"));
            Assert.That(ReceiverReport.IsPipelines("Packages/com.other/Lit.shader"), Is.False);
        }
    }
}
