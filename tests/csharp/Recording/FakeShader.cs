using System.Collections.Generic;
using System.IO;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using UnityEngine;

namespace Penumbra.Tests
{
    /// <summary>The package's shader, as far as its passes' names go: read from the file itself.</summary>
    internal static class FakeShader
    {
        internal static Shader Install()
        {
            var shader = new Shader { name = PenumbraShadows.ShaderName };
            foreach (string name in Passes()) shader.PassNames.Add(name);
            Shader.Known[PenumbraShadows.ShaderName] = shader;
            return shader;
        }

        internal static string PackageRoot([CallerFilePath] string here = "") =>
            Path.GetFullPath(Path.Combine(Path.GetDirectoryName(here), "..", "..", ".."));

        private static IEnumerable<string> Passes()
        {
            string text = File.ReadAllText(Path.Combine(PackageRoot(), "Shaders", "PenumbraShadows.shader"));
            foreach (Match name in Regex.Matches(text, "Name \"(\\w+)\"")) yield return name.Groups[1].Value;
        }
    }
}
