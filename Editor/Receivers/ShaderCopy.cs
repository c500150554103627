using System;
using System.Text.RegularExpressions;

namespace Penumbra.Editor
{
    /// <summary>Copies a package's shader into the project, with the changes that make it a separate shader.</summary>
    internal static class ShaderCopy
    {
        internal const string OfProject = "Project/";

        private static readonly Regex NameLine = new Regex("^(\\s*Shader\\s*\")([^\"\\n]*)(?=\")", RegexOptions.Multiline);

        private static readonly Regex IncludeLine =
            new Regex("^(\\s*#\\s*include(?:_with_pragmas)?\\s*\")([^\"\\n]*)(?=\")", RegexOptions.Multiline);

        /// <summary>The name for Shader.Find; null in an include file.</summary>
        internal static string Name(string text)
        {
            Match found = NameLine.Match(text);
            return found.Success ? found.Groups[2].Value : null;
        }

        /// <summary>The name of a project's copy: shader names must be unique.</summary>
        internal static string NameOf(string name) => OfProject + name;

        /// <summary>The text with the copy's name, and with include paths that work from any folder.</summary>
        /// <param name="path">The original's path, for example
        /// "Packages/com.company.package/Shaders/Water.shader".</param>
        /// <param name="exists">Whether a path of the project, including its packages, is a file.</param>
        internal static string TextOf(string text, string path, Predicate<string> exists)
        {
            text = NameLine.Replace(text, line => line.Groups[1].Value + NameOf(line.Groups[2].Value), 1);
            return IncludeLine.Replace(text, line =>
            {
                // Includes that are not beside the file are Unity's own, or already have a full path.
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
