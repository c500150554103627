using System.Collections.Generic;
using System.IO;
using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>What can be done about a shader without the screen keyword.</summary>
    public enum ReceiverFix
    {
        /// <summary>A text of the project: the keyword is added to its pragmas.</summary>
        AddKeyword,

        /// <summary>Made by Shader Graph of an older URP: reimporting makes its pragmas anew.</summary>
        Reimport,

        /// <summary>Lies in a package, which the next update would overwrite: copy it into the project.</summary>
        CopyToProject,
    }

    internal readonly struct ReceiverProblem
    {
        internal readonly string path;
        internal readonly ReceiverFix fix;

        internal ReceiverProblem(string path, ReceiverFix fix)
        {
            this.path = path;
            this.fix = fix;
        }

        internal string Explanation
        {
            get
            {
                switch (fix)
                {
                    case ReceiverFix.AddKeyword:
                        return "A multi_compile of " + ShadowKeywords.MapName + " without " +
                               ShadowKeywords.ScreenName + ": surfaces lose the main light's shadow.";
                    case ReceiverFix.Reimport:
                        return "A Shader Graph that was generated without " + ShadowKeywords.ScreenName +
                               ": reimport it.";
                    default:
                        return "In a package: copy the shader into the project, use the copy and add " +
                               ShadowKeywords.ScreenName + " there.";
                }
            }
        }
    }

    /// <summary>Looks through the project's shaders and shader includes.</summary>
    internal static class ReceiverReport
    {
        // Pipelines bring their own: URP's have the keyword wherever they need it.
        private static readonly string[] OfPipelines =
            { "Packages/com.unity.render-pipelines.", "Packages/com.unity.shadergraph", "Packages/com.penumbra.shadows" };

        internal static List<ReceiverProblem> Find()
        {
            var problems = new List<ReceiverProblem>();
            foreach (string path in AssetDatabase.GetAllAssetPaths())
                if (IsShaderText(path) && !IsPipelines(path) && File.Exists(path) &&
                    ReceiverPragma.KindOf(File.ReadAllText(path)) == ReceiverKind.LacksScreen)
                    problems.Add(new ReceiverProblem(path, FixFor(path)));
            return problems;
        }

        internal static bool IsShaderText(string path) =>
            path.EndsWith(".shader", System.StringComparison.OrdinalIgnoreCase) ||
            path.EndsWith(".hlsl", System.StringComparison.OrdinalIgnoreCase) ||
            path.EndsWith(".cginc", System.StringComparison.OrdinalIgnoreCase) ||
            path.EndsWith(".shadergraph", System.StringComparison.OrdinalIgnoreCase);

        internal static bool IsPipelines(string path)
        {
            foreach (string folder in OfPipelines)
                if (path.StartsWith(folder, System.StringComparison.Ordinal)) return true;
            return false;
        }

        internal static ReceiverFix FixFor(string path)
        {
            if (path.EndsWith(".shadergraph", System.StringComparison.OrdinalIgnoreCase)) return ReceiverFix.Reimport;
            return path.StartsWith("Assets/", System.StringComparison.Ordinal) ? ReceiverFix.AddKeyword
                                                                               : ReceiverFix.CopyToProject;
        }

        internal static void Apply(in ReceiverProblem problem)
        {
            if (problem.fix == ReceiverFix.AddKeyword)
                File.WriteAllText(problem.path, ReceiverPragma.WithScreen(File.ReadAllText(problem.path)));
            if (problem.fix == ReceiverFix.CopyToProject)
            {
                string copy = AssetDatabase.GenerateUniqueAssetPath("Assets/" + Path.GetFileName(problem.path));
                if (!AssetDatabase.CopyAsset(problem.path, copy)) return;
                File.WriteAllText(copy, ReceiverPragma.WithScreen(File.ReadAllText(copy)));
                AssetDatabase.ImportAsset(copy);
                return;
            }
            AssetDatabase.ImportAsset(problem.path);
        }
    }
}
