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

        private const string Map = "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS\n";
        private const string Cascade = "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS_CASCADE\n";
        private const string Screen = "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS_SCREEN\n";
        private const string CascadeOrScreen =
            "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN\n";
        private const string MapOrScreen = "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_SCREEN\n";

        private static string Program(string pragmas) => "HLSLPROGRAM\n" + pragmas + "ENDHLSL\n";
        private static string OldProgram(string pragmas) => "CGPROGRAM\n" + pragmas + "ENDCG\n";
        private static string Block(string pragmas) => "HLSLINCLUDE\n" + pragmas + "ENDHLSL\n";

        private static void Becomes(string before, string after)
        {
            bool lacks = before != after;
            Assert.That(ReceiverPragma.KindOf(before),
                        Is.EqualTo(lacks ? ReceiverKind.LacksScreen : ReceiverKind.Complete), before);
            Assert.That(ReceiverPragma.WithScreen(before), Is.EqualTo(after));
            Assert.That(ReceiverPragma.KindOf(after), Is.EqualTo(ReceiverKind.Complete), after);
        }

        [Test]
        public void APragmaOfItsOwnIsEnough()
        {
            Becomes(Map + Screen, Map + Screen);
            Becomes(Program(Screen + Map + Cascade), Program(Screen + Map + Cascade));
        }

        [Test]
        public void TwoPragmasOfAProgramGetItOnceAtTheCascades()
        {
            Becomes(Map + Cascade, Map + CascadeOrScreen);
            Becomes(Program(Cascade + Map), Program(CascadeOrScreen + Map));
        }

        [Test]
        public void EachProgramIsForItself()
        {
            Becomes(Program(Map + Screen) + Program(Map), Program(Map + Screen) + Program(MapOrScreen));
            Becomes(OldProgram(Map) + Program(Cascade) + Program(""),
                    OldProgram(MapOrScreen) + Program(CascadeOrScreen) + Program(""));
        }

        [Test]
        public void ABlockOfAllProgramsCountsInEach()
        {
            Becomes(Block(Screen) + Program(Map), Block(Screen) + Program(Map));
            Becomes(Program("") + Program("") + Block(Map), Program("") + Program("") + Block(MapOrScreen));
            Becomes(Block(Cascade) + Program(Map) + Program(Map + Screen),
                    Block(CascadeOrScreen) + Program(Map) + Program(Map + Screen));
        }

        [Test]
        public void TheKeywordGoesBehindThePragmasWordsAndNothingElseChanges() =>
            Becomes("Shader \"A\" {\r\n  HLSLPROGRAM\r\n  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS  // soft\r\n" +
                    "  ENDHLSL CGPROGRAM\r\n #pragma target 3.5\r\n\t#pragma multi_compile _ _MAIN_LIGHT_SHADOWS",
                    "Shader \"A\" {\r\n  HLSLPROGRAM\r\n  #pragma multi_compile _ _MAIN_LIGHT_SHADOWS" +
                    " _MAIN_LIGHT_SHADOWS_SCREEN  // soft\r\n" +
                    "  ENDHLSL CGPROGRAM\r\n #pragma target 3.5\r\n\t#pragma multi_compile _ _MAIN_LIGHT_SHADOWS" +
                    " _MAIN_LIGHT_SHADOWS_SCREEN");
    }
}
