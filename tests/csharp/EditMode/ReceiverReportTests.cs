using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;

namespace Penumbra.Tests
{
    public sealed class ReceiverReportTests
    {
        private const string Lacking = "HLSLPROGRAM\n#pragma multi_compile _ _MAIN_LIGHT_SHADOWS\nENDHLSL\n";
        private const string Whole =
            "HLSLPROGRAM\n#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_SCREEN\nENDHLSL\n";
        private const string OfPackage = "Packages/com.other.water/Shaders/Water.shader";

        private static string Named(string name, string code) => "Shader \"" + name + "\"\n{\n" + code + "}\n";

        private static ReceiverProblem[] In(Dictionary<string, string> files) =>
            ReceiverReport.In(files.Keys, path => files[path]).ToArray();

        [Test]
        public void WhatLacksTheKeywordIsFoundWithItsFix()
        {
            var files = new Dictionary<string, string>
            {
                ["Assets/Lacking.shader"] = Named("Lacking", Lacking), ["Assets/Whole.shader"] = Named("Whole", Whole),
                ["Assets/Lacking.HLSL"] = Lacking, ["Assets/Notes.txt"] = Lacking,
                ["Packages/com.unity.render-pipelines.universal/Shaders/Lit.shader"] = Lacking,
                [OfPackage] = Named("Water", Lacking), ["Packages/com.other.water/Water.hlsl"] = Lacking,
                ["Assets/Toon.shadergraph"] = ReceiverGraphTests.Graph(ReceiverGraphTests.Map),
                ["Packages/com.other.water/Toon.shadersubgraph"] = ReceiverGraphTests.Graph(ReceiverGraphTests.Map),
            };
            Assert.That(In(files).Select(problem => problem.path + " " + problem.fix), Is.EqualTo(new[]
            {
                "Assets/Lacking.shader AddKeyword", "Assets/Lacking.HLSL AddKeyword", OfPackage + " CopyToProject",
                "Packages/com.other.water/Water.hlsl EditIncluder", "Assets/Toon.shadergraph EditGraph",
                "Packages/com.other.water/Toon.shadersubgraph EditGraph",
            }));
        }

        [TestCase(0, "Every opaque shader")]
        [TestCase(1, "1 problem with")]
        [TestCase(2, "2 problems with")]
        public void TheSummaryCounts(int count, string start) =>
            Assert.That(ReceiverReport.Summary(count), Does.StartWith(start).And.EndsWith("from the screen."));

        [Test]
        public void EachExplanationNamesWhatIsMissing()
        {
            foreach (ReceiverFix fix in System.Enum.GetValues(typeof(ReceiverFix)))
            {
                bool passes = fix == ReceiverFix.AddPasses || fix == ReceiverFix.WritePasses;
                Assert.That(new ReceiverProblem("A", fix, !passes, passes ? "DepthOnly" : null).Explanation,
                            Does.Contain(passes ? "DepthOnly" : ShadowKeywords.ScreenName));
            }
        }

        [Test]
        public void APackagesShaderIsListedUntilTheProjectHasItsCopy()
        {
            var files = new Dictionary<string, string> { [OfPackage] = Named("Other/Water", Lacking) };
            ReceiverProblem problem = In(files).Single();
            files["Assets/Water.shader"] = ReceiverReport.Fixed(problem, files[OfPackage], path => false);
            Assert.That(files["Assets/Water.shader"], Is.EqualTo(Named("Project/Other/Water", Whole)));
            Assert.That(In(files), Is.Empty);
            files["Assets/Water.shader"] = Named("Project/Other/Water", Lacking);
            Assert.That(In(files).Single().path, Is.EqualTo("Assets/Water.shader"));
            files["Assets/Water.shader"] = Named("Other/Water", Whole);
            Assert.That(In(files).Single().path, Is.EqualTo(OfPackage));
        }

        [Test]
        public void ACopyFindsItsIncludesFromAnywhere()
        {
            var there = new HashSet<string>
            {
                "Packages/com.other.water/Shaders/Waves.hlsl", "Packages/com.other.water/Common/Foam.hlsl",
            };
            const string before = "HLSLPROGRAM\n#include \"Waves.hlsl\"\r\n  # include_with_pragmas \"./Waves.hlsl\"\n" +
                                  "#include \"../Shaders/../Common/Foam.hlsl\" // \"Waves.hlsl\"\n" +
                                  "#include \"UnityCG.cginc\"\n#include \"Packages/com.other/A.hlsl\"\nENDHLSL\n";
            const string after = "HLSLPROGRAM\n#include \"Packages/com.other.water/Shaders/Waves.hlsl\"\r\n" +
                                 "  # include_with_pragmas \"Packages/com.other.water/Shaders/Waves.hlsl\"\n" +
                                 "#include \"Packages/com.other.water/Common/Foam.hlsl\" // \"Waves.hlsl\"\n" +
                                 "#include \"UnityCG.cginc\"\n#include \"Packages/com.other/A.hlsl\"\nENDHLSL\n";
            Assert.That(ShaderCopy.TextOf(Named("Water", before), OfPackage, there.Contains),
                        Is.EqualTo(Named("Project/Water", after)));
        }

        [Test]
        public void AShaderOfTheProjectKeepsItsName()
        {
            var problem = new ReceiverProblem("Assets/Water.shader", ReceiverFix.AddKeyword);
            Assert.That(ReceiverReport.Fixed(problem, Named("Water", Lacking), path => true),
                        Is.EqualTo(Named("Water", Whole)));
        }

        [TestCase(ReceiverFix.EditGraph)]
        [TestCase(ReceiverFix.EditIncluder)]
        public void WhatIsDoneByHandIsLeftAlone(ReceiverFix fix) =>
            Assert.That(ReceiverReport.Fixed(new ReceiverProblem(OfPackage, fix), Lacking, path => true),
                        Is.EqualTo(Lacking));

        [Test]
        public void ThePipelinesOwnAreNotLookedAt()
        {
            Assert.That(ReceiverReport.IsPipelines("Packages/com.unity.render-pipelines.universal/Shaders/Lit.shader"));
            Assert.That(ReceiverReport.IsPipelines("Packages/com.other/Lit.shader"), Is.False);
        }
    }

    public sealed class ReceiverGraphTests
    {
        internal static readonly string Map = Boolean("_MAIN_LIGHT_SHADOWS");

        private static readonly string Screen = Boolean("_MAIN_LIGHT_SHADOWS_SCREEN");
        private static readonly string Unlit = Object("UnityEditor.Rendering.Universal.ShaderGraph.UniversalUnlitSubTarget");
        private static readonly string Lit = Object("UnityEditor.Rendering.Universal.ShaderGraph.UniversalLitSubTarget");

        /// <summary>A graph as Shader Graph writes it: objects one after the other.</summary>
        internal static string Graph(params string[] objects) =>
            Object("UnityEditor.ShaderGraph.GraphData", "\"m_Keywords\": [ { \"m_Id\": \"1\" } ]") + string.Concat(objects);

        private static string Object(string type, params string[] fields) =>
            "{\n    \"m_SGVersion\": 1,\n    \"m_Type\": \"" + type + "\",\n    \"m_ObjectId\": \"1\"" +
            string.Concat(fields.Select(field => ",\n    " + field)) + "\n}\n\n";

        private static string Keyword(string written, string made, int type, int definition, string entries) =>
            Object("UnityEditor.ShaderGraph.ShaderKeyword", "\"m_Name\": \"Shadows\"",
                   "\"m_DefaultReferenceName\": \"" + made + "\"", "\"m_OverrideReferenceName\": \"" + written + "\"",
                   "\"m_KeywordType\": " + type, "\"m_KeywordDefinition\": " + definition, "\"m_KeywordScope\": 1",
                   "\"m_Entries\": [" + entries + "]");

        private static string Boolean(string reference, int definition = 1) =>
            Keyword(reference, "BOOLEAN_1A2B3C4D", 0, definition, "");

        private static string Enumeration(string reference, params string[] entries) =>
            Keyword(reference, "_MAIN", 1, 1, string.Join(", ", entries.Select(
                entry => "{ \"id\": 1, \"displayName\": \"A\", \"referenceName\": \"" + entry + "\" }")));

        private static void Is(ReceiverKind kind, params string[] objects) =>
            Assert.That(ReceiverGraph.KindOf(Graph(objects)), NUnit.Framework.Is.EqualTo(kind));

        [Test]
        public void AGraphWithoutTheKeywordsIsLeftToItsTarget()
        {
            Is(ReceiverKind.None, Lit);
            Is(ReceiverKind.None, Unlit, Boolean("_RAIN"), Screen);
            Assert.That(ReceiverGraph.KindOf(""), NUnit.Framework.Is.EqualTo(ReceiverKind.None));
        }

        [Test]
        public void AKeywordOfTheMapNeedsTheScreens()
        {
            Is(ReceiverKind.LacksScreen, Unlit, Map);
            Is(ReceiverKind.LacksScreen, Boolean("_MAIN_LIGHT_SHADOWS_CASCADE"), Unlit);
            Is(ReceiverKind.LacksScreen, Keyword("", "_MAIN_LIGHT_SHADOWS", 0, 1, ""));
            Is(ReceiverKind.Complete, Unlit, Map, Screen);
        }

        [Test]
        public void TheLitTargetBringsIt() => Is(ReceiverKind.Complete, Map, Lit);

        [Test]
        public void APredefinedKeywordDeclaresNothing()
        {
            Is(ReceiverKind.None, Unlit, Boolean("_MAIN_LIGHT_SHADOWS", definition: 2));
            Is(ReceiverKind.LacksScreen, Unlit, Map, Boolean("_MAIN_LIGHT_SHADOWS_SCREEN", definition: 2));
        }

        [Test]
        public void AnEnumerationsEntriesAreItsKeywords()
        {
            Is(ReceiverKind.LacksScreen, Unlit, Enumeration("_MAIN_LIGHT", "OFF", "SHADOWS"));
            Is(ReceiverKind.LacksScreen, Unlit, Enumeration("", "LIGHT_SHADOWS_CASCADE"));
            Is(ReceiverKind.Complete, Unlit, Enumeration("_MAIN_LIGHT", "SHADOWS", "SHADOWS_SCREEN"));
            Is(ReceiverKind.None, Unlit, Enumeration("_MAIN_LIGHT_SHADOWS", "OFF"));
        }
    }
}
