using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using UnityEngine;

namespace Penumbra.Tests
{
    /// <summary>The package's shaders, as far as their passes' names and keywords go: read from the files themselves.</summary>
    internal static class FakeShader
    {
        private const string FrameFile = "PenumbraShadows.shader";

        /// <summary>Both shaders; the frame's own comes back.</summary>
        internal static Shader Install()
        {
            Install(DebugViewDraw.ShaderName, "PenumbraDebugViews.shader");
            return Install(PenumbraShadows.ShaderName, FrameFile);
        }

        private static Shader Install(string name, string file)
        {
            var shader = new Shader { name = name };
            foreach (string pass in Passes(file)) shader.PassNames.Add(pass);
            Shader.Known[name] = shader;
            return shader;
        }

        internal static string PackageRoot([CallerFilePath] string here = "") =>
            Path.GetFullPath(Path.Combine(Path.GetDirectoryName(here), "..", "..", ".."));

        private static string Text(string file) => File.ReadAllText(Path.Combine(PackageRoot(), "Shaders", file));

        private static IEnumerable<string> Passes(string file)
        {
            foreach (Match name in Regex.Matches(Text(file), "Name \"(\\w+)\"")) yield return name.Groups[1].Value;
        }

        /// <summary>Of the frame's shader, by pass the keyword sets of its fragment programs: one keyword of every multi_compile line.</summary>
        internal static Dictionary<string, List<HashSet<string>>> FragmentVariants()
        {
            var variants = new Dictionary<string, List<HashSet<string>>>();
            foreach (Match pass in Regex.Matches(Text(FrameFile), "Name \"(\\w+)\"(.*?)ENDHLSL", RegexOptions.Singleline))
            {
                var sets = new List<HashSet<string>> { new HashSet<string>() };
                foreach (Match line in Regex.Matches(pass.Groups[2].Value, "#pragma multi_compile_local_fragment (.*)"))
                    sets = sets.SelectMany(set => line.Groups[1].Value.Split(' ').Select(name => With(set, name)))
                        .ToList();
                variants.Add(pass.Groups[1].Value, sets);
            }
            return variants;
        }

        private static HashSet<string> With(HashSet<string> set, string name) =>
            new HashSet<string>(name == "_" ? set : set.Append(name));
    }
}
