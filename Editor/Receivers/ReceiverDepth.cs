using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Penumbra.Editor
{
    /// <summary>
    /// URP draws the depth from which screen-space shadows are computed with a pass of each shader: DepthOnly or, if
    /// another feature requests normals, DepthNormals or DepthNormalsOnly. An opaque shader without that pass is not
    /// in the depth texture, and receives the shadow of the surface behind it. UsePass can take the missing passes
    /// from URP's lit shaders.
    /// </summary>
    internal static class ReceiverDepth
    {
        internal const string DepthOnly = "DepthOnly";
        internal const string DepthNormals = "DepthNormals";
        internal const string DepthNormalsOnly = "DepthNormalsOnly";

        private const string Pipeline = "UniversalPipeline";
        private const int LastOpaqueQueue = 2500;

        // URP draws these light modes forward even in a deferred renderer. A pass without the tag counts as
        // SRPDefaultUnlit.
        private static readonly string[] ForwardOnlyModes = { "UniversalForwardOnly", "SRPDefaultUnlit", "" };

        // Lit's passes would not reproduce such clipping, since they clip by Lit's own texture and threshold.
        private static readonly Regex Cut = new Regex(@"\b(clip|AlphaDiscard|AlphaClip)\s*\(|\bdiscard\b");

        /// <summary>
        /// Names of the passes that any SubShader of the text lacks, each once; empty if none is missing.
        /// </summary>
        internal static List<string> Lacking(string text)
        {
            var lacking = new SortedSet<string>(StringComparer.Ordinal);
            if (IsHidden(text)) return lacking.ToList();
            ShaderStructure structure = ShaderStructure.Of(text);
            foreach (SubShaderText subShader in structure.subShaders)
                lacking.UnionWith(Lacking(subShader, structure.shared));
            return lacking.ToList();
        }

        // Such shaders have no materials: they draw over the screen, or over another shader's image, like further
        // layers of terrains.
        private static bool IsHidden(string text) =>
            ShaderCopy.Name(text)?.StartsWith("Hidden/", StringComparison.Ordinal) == true;

        /// <summary>
        /// The text with passes of URP's lit shaders added at the end of each SubShader that lacks them. SubShaders
        /// that clip pixels are not changed: they need passes that clip the same way.
        /// </summary>
        internal static string WithPasses(string text)
        {
            ShaderStructure structure = ShaderStructure.Of(text);
            foreach (SubShaderText subShader in Enumerable.Reverse(structure.subShaders))
            {
                List<string> passes = Lacking(subShader, structure.shared);
                if (passes.Count == 0 || Cuts(subShader, structure.shared)) continue;
                int line = text.LastIndexOf('\n', subShader.end) + 1;
                string before = text.Substring(line, subShader.end - line);
                bool ownLine = before.Trim().Length == 0;
                string indent = ownLine ? before : "";
                string newline = LineEndBefore(text, line);
                string added = string.Concat(passes.Select(pass => indent + "    UsePass \"" + Lent(pass) + "\"" + newline));
                text = ownLine ? text.Insert(line, added) : text.Insert(subShader.end, newline + added);
            }
            return text;
        }

        // The line ending of the previous line, or of the first line if there is none.
        private static string LineEndBefore(string text, int line)
        {
            int end = line > 0 ? line - 1 : text.IndexOf('\n');
            return end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
        }

        // Unity converts the names of passes to upper case, and finds them only in upper case.
        private static string Lent(string pass) =>
            "Universal Render Pipeline/" + (pass == DepthNormalsOnly ? "Complex Lit/" : "Lit/") + pass.ToUpperInvariant();

        private static List<string> Lacking(SubShaderText subShader, string shared)
        {
            bool isUrps = subShader.pipeline.Length == 0 ||
                          subShader.pipeline.Equals(Pipeline, StringComparison.OrdinalIgnoreCase);
            List<ShaderPassText> receivers = Receivers(subShader, shared).ToList();
            var lacking = new List<string>();
            if (!isUrps || receivers.Count == 0 || subShader.queue > LastOpaqueQueue) return lacking;
            if (!Has(subShader, DepthOnly)) lacking.Add(DepthOnly);
            bool isForwardOnly = receivers.Exists(pass => ForwardOnlyModes.Contains(pass.lightMode));
            if (!HasNormals(subShader, isForwardOnly)) lacking.Add(isForwardOnly ? DepthNormalsOnly : DepthNormals);
            return lacking;
        }

        private static IEnumerable<ShaderPassText> Receivers(SubShaderText subShader, string shared) =>
            subShader.passes.Where(pass => ReceiverPragma.KindOf(shared + pass.code) != ReceiverKind.None);

        private static bool HasNormals(SubShaderText subShader, bool isForwardOnly)
        {
#if !UNITY_6000_0_OR_NEWER
            // A deferred renderer of URP 14 draws what is not in its G-buffer only with this pass.
            if (isForwardOnly) return Has(subShader, DepthNormalsOnly);
#endif
            return Has(subShader, DepthNormals) || Has(subShader, DepthNormalsOnly);
        }

        private static bool Cuts(SubShaderText subShader, string shared) =>
            Cut.IsMatch(shared) || Receivers(subShader, shared).Any(pass => Cut.IsMatch(pass.code));

        // A pass taken by UsePass is identified by its name, which in URP's shaders equals its light mode.
        private static bool Has(SubShaderText subShader, string pass) =>
            subShader.passes.Any(own => own.lightMode == pass) ||
            subShader.takenPasses.Any(taken => taken.Equals(pass, StringComparison.OrdinalIgnoreCase));
    }
}
