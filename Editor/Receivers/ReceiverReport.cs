using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// The way to fix a shader that cannot read the screen-space texture, or reads another surface's shadow.
    /// </summary>
    public enum ReceiverFix
    {
        /// <summary>A file of the project: the keyword is added to its pragmas.</summary>
        AddKeyword,

        /// <summary>
        /// A file of a package, which the next update would overwrite: it is copied into the project.
        /// </summary>
        CopyToProject,

        /// <summary>A Shader Graph: its author must change its blackboard.</summary>
        EditGraph,

        /// <summary>
        /// An include file in a package: shaders that include it with its pragmas need a pragma of their own.
        /// </summary>
        EditIncluder,

        /// <summary>A file of the project without depth passes: the passes of URP's lit shaders are added.</summary>
        AddPasses,

        /// <summary>
        /// The shader lacks depth passes, too, but it clips pixels, which those of URP's lit shaders do not: its author
        /// must write the passes.
        /// </summary>
        WritePasses,
    }

    [Serializable]
    internal struct ReceiverProblem
    {
        [SerializeField] internal string path;
        [SerializeField] internal ReceiverFix fix;

        /// <summary>
        /// Whether the keyword is missing; `passes` names the missing passes, null or empty for none.
        /// </summary>
        [SerializeField] internal bool lacksScreen;
        [SerializeField] internal string passes;

        internal ReceiverProblem(string path, ReceiverFix fix, bool lacksScreen = true, string passes = null)
        {
            this.path = path;
            this.fix = fix;
            this.lacksScreen = lacksScreen;
            this.passes = passes;
        }

        /// <summary>Whether Apply can fix the problem; otherwise the explanation describes the manual fix.</summary>
        internal bool CanApply =>
            fix != ReceiverFix.EditGraph && fix != ReceiverFix.EditIncluder && fix != ReceiverFix.WritePasses;

        internal bool LacksPasses => !string.IsNullOrEmpty(passes);

        private string Lacks => !lacksScreen ? NoDepth : !LacksPasses ? NoScreen : NoScreen + " " + NoDepth;

        private const string NoScreen = "A multi_compile of " + ShadowKeywords.MapName + " without " +
                                        ShadowKeywords.ScreenName + ": surfaces lose the main light's shadow.";

        private string NoDepth =>
            "No pass " + passes + ": " + WhereItMatters + "surfaces are not in the depth texture, and receive the main light's " +
            "shadow of the surfaces behind them.";

        // A missing DepthOnly matters in every project.
        private string WhereItMatters
        {
            get
            {
                if (passes == ReceiverDepth.DepthNormals) return OtherNormals + ", ";
                return passes == ReceiverDepth.DepthNormalsOnly ? OtherNormals + " and in Deferred, " : "";
            }
        }

        private const string OtherNormals = "where another feature requests normals, as Ambient Occlusion does";

        private const string Lent =
            " The passes of URP's lit shaders can be added by UsePass. If this shader moves vertices or clips pixels in an " +
            "include file, write passes that do the same instead. The SRP Batcher does not batch the shader unless " +
            "its UnityPerMaterial is the same as Lit's.";

        internal string Explanation
        {
            get
            {
                switch (fix)
                {
                    case ReceiverFix.AddKeyword:
                        return NoScreen;
                    case ReceiverFix.AddPasses:
                        return NoDepth + Lent;
                    case ReceiverFix.WritePasses:
                        return NoDepth + " The shader clips pixels (clip or discard), which the passes of URP's lit " +
                               "shaders do not: write passes that clip the same way.";
                    case ReceiverFix.CopyToProject:
                        return Lacks + " In a package: copy the shader into the project, where the missing parts and the " +
                               "name prefix " + ShaderCopy.OfProject + " are added, and choose the copy in materials.";
                    case ReceiverFix.EditGraph:
                        return "The blackboard has " + ShadowKeywords.MapName + " without " +
                               ShadowKeywords.ScreenName + ". Add a Boolean keyword with that reference, Multi Compile " +
                               "and Global. Where it is defined, URP's functions take ComputeScreenPos(TransformWorldToHClip(" +
                               "position)) as the shadow coordinate.";
                    default:
                        return "An include file in a package. In each shader of the project that includes it with " +
                               "#include_with_pragmas, add #pragma multi_compile _ " + ShadowKeywords.ScreenName + ".";
                }
            }
        }
    }

    /// <summary>Searches the project's shaders, shader includes and Shader Graphs.</summary>
    internal static class ReceiverReport
    {
        private const string OfProject = "Assets/";

        // Pipelines are skipped: URP's shaders have the keyword wherever they need it.
        private static readonly string[] OfPipelines =
            { "Packages/com.unity.render-pipelines.", "Packages/com.unity.shadergraph", "Packages/com.penumbra.shadows" };

        private static readonly string[] Includes = { ".hlsl", ".cginc" };
        private static readonly string[] Graphs = { ".shadergraph", ".shadersubgraph" };
        private static readonly string[] Shaders = { ".shader" };

        internal static List<ReceiverProblem> Find() =>
            In(AssetDatabase.GetAllAssetPaths().Where(IsFile), path => ShaderFile.Read(path).text);

        /// <summary>The number of problems, of shaders and of renderers together.</summary>
        internal static string Summary(int count)
        {
            if (count == 0) return "Every opaque shader that receives the main light's shadow can read it from the screen.";
            return count + (count == 1 ? " problem" : " problems") +
                   " with reading the main light's shadow from the screen.";
        }

        /// <summary>A package's shader is not reported once the project contains its copy.</summary>
        internal static List<ReceiverProblem> In(IEnumerable<string> paths, Func<string, string> read)
        {
            var lacking = new List<(ReceiverProblem problem, string name)>();
            var names = new HashSet<string>();
            foreach (string path in paths)
            {
                if (!IsShaderText(path) || IsPipelines(path)) continue;
                string text = read(path);
                string name = ShaderCopy.Name(text);
                if (name != null && IsProjects(path)) names.Add(name);
                foreach (ReceiverProblem problem in Of(path, text)) lacking.Add((problem, name));
            }
            return lacking.Where(one => IsProjects(one.problem.path) || one.name == null ||
                                        !names.Contains(ShaderCopy.NameOf(one.name)))
                .Select(one => one.problem).ToList();
        }

        // A shader of the project has one fix per problem; one of a package is copied with all fixes applied.
        private static IEnumerable<ReceiverProblem> Of(string path, string text)
        {
            bool lacksScreen = KindOf(path, text) == ReceiverKind.LacksScreen;
            string passes = EndsWith(path, Shaders) ? string.Join(" and ", ReceiverDepth.Lacking(text)) : "";
            if (passes.Length == 0)
            {
                if (lacksScreen) yield return new ReceiverProblem(path, FixFor(path));
            }
            else if (!IsProjects(path))
            {
                yield return new ReceiverProblem(path, ReceiverFix.CopyToProject, lacksScreen, passes);
            }
            else
            {
                if (lacksScreen) yield return new ReceiverProblem(path, ReceiverFix.AddKeyword);
                bool lends = ReceiverDepth.WithPasses(text) != text;
                yield return new ReceiverProblem(path, lends ? ReceiverFix.AddPasses : ReceiverFix.WritePasses, false, passes);
            }
        }

        internal static ReceiverKind KindOf(string path, string text) =>
            EndsWith(path, Graphs) ? ReceiverGraph.KindOf(text) : ReceiverPragma.KindOf(text);

        internal static bool IsShaderText(string path) =>
            EndsWith(path, Shaders) || EndsWith(path, Includes) || EndsWith(path, Graphs);

        internal static bool IsPipelines(string path) =>
            OfPipelines.Any(folder => path.StartsWith(folder, StringComparison.Ordinal));

        internal static ReceiverFix FixFor(string path)
        {
            if (EndsWith(path, Graphs)) return ReceiverFix.EditGraph;
            if (IsProjects(path)) return ReceiverFix.AddKeyword;
            return EndsWith(path, Includes) ? ReceiverFix.EditIncluder : ReceiverFix.CopyToProject;
        }

        /// <summary>The text at `path` with the fix applied.</summary>
        internal static string Fixed(in ReceiverProblem problem, string text, Predicate<string> exists)
        {
            if (problem.fix == ReceiverFix.CopyToProject) text = ShaderCopy.TextOf(text, problem.path, exists);
            if (!problem.CanApply) return text;
            if (problem.lacksScreen) text = ReceiverPragma.WithScreen(text);
            return problem.LacksPasses ? ReceiverDepth.WithPasses(text) : text;
        }

        /// <summary>
        /// Applies the fix if CanApply; throws IOException with the reason if the file cannot be written.
        /// </summary>
        internal static void Apply(in ReceiverProblem problem)
        {
            ShaderFile file = ShaderFile.Read(problem.path);
            string text = Fixed(problem, file.text, IsFile);
            string target = problem.path;
            if (problem.fix == ReceiverFix.CopyToProject)
            {
                target = AssetDatabase.GenerateUniqueAssetPath(OfProject + Path.GetFileName(problem.path));
                if (!AssetDatabase.CopyAsset(problem.path, target))
                    throw new IOException(problem.path + " cannot be copied to " + target + ". Check that the folder is " +
                                          "writable, and try again.");
                ShaderFile.MakeWritable(target);
            }
            file.Write(target, text);
            AssetDatabase.ImportAsset(target);
        }

        // A package's asset path is not its location on disk; the full path is.
        private static bool IsFile(string path) => File.Exists(Path.GetFullPath(path));

        private static bool IsProjects(string path) => path.StartsWith(OfProject, StringComparison.Ordinal);

        private static bool EndsWith(string path, string[] endings) =>
            endings.Any(ending => path.EndsWith(ending, StringComparison.OrdinalIgnoreCase));
    }
}
