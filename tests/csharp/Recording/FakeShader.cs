using System.Collections.Generic;
using System.IO;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using UnityEngine;

namespace Penumbra.Tests
{
    /// <summary>The package's shaders, as far as their passes' names go: read from the files themselves.</summary>
    internal static class FakeShader
    {
        /// <summary>Both shaders; the frame's own comes back.</summary>
        internal static Shader Install()
        {
            Install(DebugViewDraw.ShaderName, "PenumbraDebugViews.shader");
            return Install(PenumbraShadows.ShaderName, "PenumbraShadows.shader");
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

        private static IEnumerable<string> Passes(string file)
        {
            string text = File.ReadAllText(Path.Combine(PackageRoot(), "Shaders", file));
            foreach (Match name in Regex.Matches(text, "Name \"(\\w+)\"")) yield return name.Groups[1].Value;
        }
    }
}
