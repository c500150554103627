using System;
using System.Text.RegularExpressions;

namespace Penumbra.Editor
{
    /// <summary>A package's shader copied into the project: what it says otherwise, to be a shader of its own.</summary>
    internal static class ShaderCopy
    {
        internal const string OfProject = "Project/";

        private static readonly Regex NameLine = new Regex("^(\\s*Shader\\s*\")([^\"\\n]*)(?=\")", RegexOptions.Multiline);

        private static readonly Regex IncludeLine =
            new Regex("^(\\s*#\\s*include(?:_with_pragmas)?\\s*\")([^\"\\n]*)(?=\")", RegexOptions.Multiline);

        /// <summary>The name that shaders are found by; null in an include file.</summary>
        internal static string Name(string text)
        {
            Match found = NameLine.Match(text);
            return found.Success ? found.Groups[2].Value : null;
        }

        /// <summary>The name of a project's copy: no two shaders may have one name.</summary>
        internal static string NameOf(string name) => OfProject + name;

        /// <summary>The text under the copy's name, with includes that are found from anywhere.</summary>
        /// <param name="path">Of the original: "Packages/com.company.package/Shaders/Water.shader".</param>
        /// <param name="exists">Whether a path of the project, its packages among them, is a file.</param>
        internal static string TextOf(string text, string path, Predicate<string> exists)
        {
            text = NameLine.Replace(text, line => line.Groups[1].Value + NameOf(line.Groups[2].Value), 1);
            return IncludeLine.Replace(text, line =>
            {
                // What does not lie beside the file is one of Unity's own, or has its whole path already.
                string full = Beside(path, line.Groups[2].Value);
                return line.Groups[1].Value + (exists(full) ? full : line.Groups[2].Value);
            });
        }

        private static string Beside(string path, string include)
        {
            string full = path.Substring(0, path.LastIndexOf('/') + 1) + include.Replace('\\', '/');
            full = full.Replace("/./", "/");
            for (string before = null; before != full;)
            {
                before = full;
                full = new Regex("[^/]+/\\.\\./").Replace(full, "", 1);
            }
            return full;
        }
    }
}
