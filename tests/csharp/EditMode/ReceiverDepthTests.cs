using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Penumbra.Editor;

namespace Penumbra.Tests
{
    /// <summary>Opaque receivers that are in no depth texture, and what the window makes of them.</summary>
    public sealed class ReceiverDepthTests
    {
        private const string Pragma = "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_SCREEN\n";
        private const string Program = "HLSLPROGRAM\n" + Pragma + "ENDHLSL\n";
        private const string Forward = "Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n" + Program + "}\n";
        private const string Depth = "Pass { Name \"D\" Tags { \"LightMode\" = \"DepthOnly\" } }\n";
        private const string Normals = "Pass { Tags { \"LightMode\" = \"DepthNormals\" } }\n";

        private static string SubShader(string inside, string tags = "") =>
            "SubShader\n{\n" + (tags.Length > 0 ? "Tags { " + tags + " }\n" : "") + inside + "}\n";

        private static string Shader(params string[] subShaders) =>
            "Shader \"A\"\n{\n    Properties { _A (\"A { [Pass]\", 2D) = \"white\" {} }\n" + string.Concat(subShaders) +
            "    FallBack \"Universal Render Pipeline/Lit\"\n}\n";

        private static string Lacking(params string[] subShaders) =>
            string.Join(" ", ReceiverDepth.Lacking(Shader(subShaders)));

        [Test]
        public void BothPassesAreLookedFor()
        {
            Assert.That(Lacking(SubShader(Forward)), Is.EqualTo("DepthNormals DepthOnly"));
            Assert.That(Lacking(SubShader(Forward + Depth)), Is.EqualTo("DepthNormals"));
            Assert.That(Lacking(SubShader(Forward + Normals)), Is.EqualTo("DepthOnly"));
            Assert.That(Lacking(SubShader(Forward + Depth + Normals)), Is.Empty);
            Assert.That(Lacking(SubShader(Forward + Depth + Normals.Replace("Normals", "NormalsOnly"))), Is.Empty);
        }

        // A deferred renderer has these in no G-buffer: ForwardOnly, and no tag at all, which URP draws as
        // SRPDefaultUnlit.
        [TestCase("Tags { \"LightMode\" = \"UniversalForwardOnly\" }")]
        [TestCase("Tags { \"LightMode\" = \"SRPDefaultUnlit\" }")]
        [TestCase("")]
        public void WhatIsForwardInDeferredTooNeedsThePassOfThat(string tags)
        {
            string forward = "Pass { " + tags + "\n" + Program + "}\n";
            string only = Normals.Replace("Normals", "NormalsOnly");
            Assert.That(Lacking(SubShader(forward)), Is.EqualTo("DepthNormalsOnly DepthOnly"));
            Assert.That(Lacking(SubShader(forward + Depth + only)), Is.Empty);
#if UNITY_6000_0_OR_NEWER
            Assert.That(Lacking(SubShader(forward + Depth + Normals)), Is.Empty);
#else
            Assert.That(Lacking(SubShader(forward + Depth + Normals)), Is.EqualTo("DepthNormalsOnly"));
#endif
            string with = ReceiverDepth.WithPasses(Shader(SubShader(forward)));
            Assert.That(with, Does.Contain("UsePass \"Universal Render Pipeline/Complex Lit/DEPTHNORMALSONLY\"\n"));
            Assert.That(ReceiverDepth.Lacking(with), Is.Empty);
        }

        [Test]
        public void ATakenPassCounts()
        {
            const string taken = "UsePass \"Universal Render Pipeline/Lit/DEPTHONLY\"\n";
            Assert.That(Lacking(SubShader(Forward + taken)), Is.EqualTo("DepthNormals"));
            Assert.That(Lacking(SubShader(Forward + taken + "UsePass \"Other/DepthNormalsOnly\"\n")), Is.Empty);
        }

        [TestCase("")]
        [TestCase("\"RenderPipeline\" = \"UniversalPipeline\"")]
        [TestCase("\"Queue\" = \"Geometry+499\"")]
        [TestCase("\"Queue\" = \"AlphaTest\" \"RenderType\"=\"TransparentCutout\"")]
        [TestCase("\"Queue\" = \"Background + 10\"")]
        public void OpaqueReceiversNeedThem(string tags) =>
            Assert.That(Lacking(SubShader(Forward, tags)), Is.Not.Empty);

        [TestCase("\"Queue\" = \"Transparent\"")]
        [TestCase("\"queue\" = \"transparent-100\"")]
        [TestCase("\"Queue\" = \"AlphaTest+51\"")]
        [TestCase("\"Queue\" = \"Overlay\"")]
        [TestCase("\"RenderPipeline\" = \"HDRenderPipeline\"")]
        public void OthersDoNot(string tags) => Assert.That(Lacking(SubShader(Forward, tags)), Is.Empty);

        [Test]
        public void WhatTakesNoShadowNeedsNone()
        {
            Assert.That(Lacking(SubShader(Forward.Replace(Pragma, ""))), Is.Empty);
            Assert.That(Lacking(SubShader("/* " + Forward + " */\n// " + Forward.Replace("\n", " "))), Is.Empty);
            Assert.That(ReceiverDepth.Lacking(Program), Is.Empty, "an include file has no passes");
            Assert.That(ReceiverDepth.Lacking(""), Is.Empty);
            Assert.That(ReceiverDepth.Lacking(Shader(SubShader(Forward)).Replace("\"A\"", "\"Hidden/A\"")), Is.Empty);
        }

        [Test]
        public void ASharedBlocksKeywordsAreEveryPrograms()
        {
            const string pass = "Pass { HLSLPROGRAM\nENDHLSL }\n";
            Assert.That(Lacking("HLSLINCLUDE\n" + Pragma + "ENDHLSL\n", SubShader(pass)), Is.Not.Empty);
        }

        [Test]
        public void BracesInProgramsStringsAndCommentsAreNoStructure()
        {
            const string odd = "Pass { Name \"}\" Tags { \"LightMode\" = \"UniversalForward\" } // }\n" +
                               "/* } */ Stencil { Ref 1 Pass Replace }\n" +
                               "HLSLPROGRAM\n" + Pragma + "void f() { \"SubShader\"; } }\nENDHLSL\n}\n";
            Assert.That(Lacking(SubShader(odd + Depth + Normals)), Is.Empty);
            Assert.That(Lacking(SubShader(odd), SubShader(Forward + Depth)), Is.EqualTo("DepthNormals DepthOnly"));
        }

        [Test]
        public void ThePassesAreTakenFromUrpsLitShader()
        {
            string whole = SubShader(Forward + Depth + Normals);
            string text = Shader("    SubShader\n    {\n        LOD 100\n" + Forward + "    }\n", whole,
                                 SubShader(Forward + Depth)).Replace("\n", "\r\n");
            string with = ReceiverDepth.WithPasses(text);
            Assert.That(ReceiverDepth.Lacking(with), Is.Empty);
            Assert.That(with, Is.EqualTo(Shader(
                "    SubShader\n    {\n        LOD 100\n" + Forward +
                "        UsePass \"Universal Render Pipeline/Lit/DEPTHONLY\"\n" +
                "        UsePass \"Universal Render Pipeline/Lit/DEPTHNORMALS\"\n    }\n", whole,
                SubShader(Forward + Depth + "    UsePass \"Universal Render Pipeline/Lit/DEPTHNORMALS\"\n"))
                .Replace("\n", "\r\n")));
            Assert.That(ReceiverDepth.WithPasses(with), Is.EqualTo(with));
        }

        [Test]
        public void AddedLinesEndAsTheLineAbove()
        {
            string windows = SubShader(Forward).Replace("\n", "\r\n"), unix = SubShader(Forward);
            string added = ReceiverDepth.WithPasses("Shader \"A\"\n{\n" + windows + unix + "}\n");
            Assert.That(added, Does.Contain("}\r\n    UsePass \"Universal Render Pipeline/Lit/DEPTHONLY\"\r\n    UsePass")
                            .And.Contains("}\n    UsePass \"Universal Render Pipeline/Lit/DEPTHONLY\"\n    UsePass"));
        }

        [Test]
        public void ABraceAfterOtherTextStaysTheLast()
        {
            string with = ReceiverDepth.WithPasses("Shader \"A\" { SubShader { " + Forward.TrimEnd() + " } }");
            Assert.That(ReceiverDepth.Lacking(with), Is.Empty);
            Assert.That(with, Does.EndWith("DEPTHNORMALS\"\n} }"));
        }

        private static ReceiverProblem[] Problems(string path, string text) =>
            ReceiverReport.In(new[] { path }, one => text).ToArray();

        [Test]
        public void AShaderOfTheProjectGetsEachByItsOwnButton()
        {
            const string path = "Assets/Water.shader";
            string text = Shader(SubShader(Forward.Replace(" _MAIN_LIGHT_SHADOWS_SCREEN", "")));
            ReceiverProblem[] problems = Problems(path, text);
            Assert.That(problems.Select(problem => problem.fix),
                        Is.EqualTo(new[] { ReceiverFix.AddKeyword, ReceiverFix.AddPasses }));
            Assert.That(problems[1].CanApply);
            Assert.That(problems[1].Explanation, Does.Contain("DepthNormals and DepthOnly").And.Contain("UsePass"));
            text = ReceiverReport.Fixed(problems[0], text, one => true);
            Assert.That(Problems(path, text).Single().fix, Is.EqualTo(ReceiverFix.AddPasses));
            text = ReceiverReport.Fixed(problems[1], text, one => true);
            Assert.That(Problems(path, text), Is.Empty);
        }

        [TestCase("clip(alpha - _Cutoff);")]
        [TestCase("if (alpha < 0.5) discard;")]
        [TestCase("AlphaDiscard (alpha, _Cutoff);")]
        public void HolesAreNotFilledByALentPass(string cut)
        {
            const string path = "Assets/Leaves.shader";
            string cutting = Shader(SubShader(Forward.Replace("ENDHLSL", cut + "\nENDHLSL")));
            foreach (string text in new[] { cutting, Shader("HLSLINCLUDE\n" + cut + "\nENDHLSL\n", SubShader(Forward)) })
            {
                ReceiverProblem problem = Problems(path, text).Single();
                Assert.That(problem.fix, Is.EqualTo(ReceiverFix.WritePasses));
                Assert.That(problem.CanApply, Is.False);
                Assert.That(problem.Explanation, Does.Contain("DepthNormals and DepthOnly").And.Contain("clips pixels"));
                Assert.That(ReceiverReport.Fixed(problem, text, one => true), Is.EqualTo(text));
            }
            // The SubShader that clips stands beside one that does not, which is helped first.
            string two = Shader(SubShader(Forward.Replace("ENDHLSL", cut + "\nENDHLSL")), SubShader(Forward));
            ReceiverProblem first = Problems(path, two).Single();
            Assert.That(first.fix, Is.EqualTo(ReceiverFix.AddPasses));
            Assert.That(Problems(path, ReceiverReport.Fixed(first, two, one => true)).Single().fix,
                        Is.EqualTo(ReceiverFix.WritePasses));
        }

        [Test]
        public void WordsThatOnlyBeginAlikeCutNothing()
        {
            const string alike = "float4 clipPosition; Eclip(1); discarded = 1;\nENDHLSL";
            string text = Shader(SubShader(Forward.Replace("ENDHLSL", alike)));
            Assert.That(Problems("Assets/A.shader", text).Single().fix, Is.EqualTo(ReceiverFix.AddPasses));
        }

        [Test]
        public void WhereAPassMattersIsSaid()
        {
            string Said(string inside) => Problems("Assets/A.shader", Shader(SubShader(inside))).Single().Explanation;
            Assert.That(Said(Forward + Normals), Does.StartWith("No pass DepthOnly: surfaces"));
            Assert.That(Said(Forward + Depth), Does.StartWith("No pass DepthNormals: where another feature requests normals")
                                                   .And.Not.Contain("Deferred"));
            Assert.That(Said("Pass {\n" + Program + "}\n" + Depth), Does.Contain("and in Deferred, surfaces"));
        }

        [Test]
        public void APackagesShaderGetsAllInItsCopy()
        {
            const string path = "Packages/com.other.water/Water.shader";
            string text = Shader(SubShader(Forward.Replace(" _MAIN_LIGHT_SHADOWS_SCREEN", "")));
            ReceiverProblem problem = Problems(path, text).Single();
            Assert.That(problem.fix, Is.EqualTo(ReceiverFix.CopyToProject));
            Assert.That(problem.Explanation, Does.Contain("DepthOnly").And.Contain(ShadowKeywords.ScreenName));
            Assert.That(Problems("Assets/Water.shader", ReceiverReport.Fixed(problem, text, one => false)), Is.Empty);
            problem = Problems(path, Shader(SubShader(Forward))).Single();
            Assert.That(problem.Explanation, Does.Contain("DepthOnly").And.Not.Contain(ShadowKeywords.ScreenName));
        }
    }
}
