using System;
using System.Collections.Generic;
using System.Linq;

namespace Penumbra.Editor
{
    /// <summary>
    /// URP draws the depth that screen-space shadows are computed from by each shader's own pass: DepthOnly, or where
    /// another feature asks for normals DepthNormals or DepthNormalsOnly. An opaque shader without it is not in the depth
    /// texture, and takes the shadow of what lies behind. URP's lit shader has passes to lend.
    /// </summary>
    internal static class ReceiverDepth
    {
        internal const string DepthOnly = "DepthOnly";
        internal const string DepthNormals = "DepthNormals";

        private const string Lender = "Universal Render Pipeline/Lit/";
        private const string Pipeline = "UniversalPipeline";
        private const int LastOpaqueQueue = 2500;

        /// <summary>Names of the passes that a SubShader of the text lacks, each once; none where nothing is missing.</summary>
        internal static List<string> Lacking(string text)
        {
            var lacking = new SortedSet<string>(StringComparer.Ordinal);
            if (IsHidden(text)) return lacking.ToList();
            ShaderStructure structure = ShaderStructure.Of(text);
            foreach (SubShaderText subShader in structure.subShaders)
                lacking.UnionWith(Lacking(subShader, structure.shared));
            return lacking.ToList();
        }

        // Of no material: it draws over the screen, or over what another shader has drawn, as terrains' further layers.
        private static bool IsHidden(string text) =>
            ShaderCopy.Name(text)?.StartsWith("Hidden/", StringComparison.Ordinal) == true;

        /// <summary>The text with the passes taken from URP's lit shader, at the end of each SubShader that lacks them.</summary>
        internal static string WithPasses(string text)
        {
            ShaderStructure structure = ShaderStructure.Of(text);
            string newline = text.Contains("\r\n") ? "\r\n" : "\n";
            foreach (SubShaderText subShader in Enumerable.Reverse(structure.subShaders))
            {
                List<string> passes = Lacking(subShader, structure.shared);
                if (passes.Count == 0) continue;
                int line = text.LastIndexOf('\n', subShader.end) + 1;
                string before = text.Substring(line, subShader.end - line);
                bool ownLine = before.Trim().Length == 0;
                string indent = ownLine ? before : "";
                string added = string.Concat(passes.Select(pass => indent + "    UsePass \"" + Lender + pass + "\"" + newline));
                text = ownLine ? text.Insert(line, added) : text.Insert(subShader.end, newline + added);
            }
            return text;
        }

        private static List<string> Lacking(SubShaderText subShader, string shared)
        {
            bool isUrps = subShader.pipeline.Length == 0 ||
                          subShader.pipeline.Equals(Pipeline, StringComparison.OrdinalIgnoreCase);
            bool receives = subShader.passes.Any(pass => ReceiverPragma.KindOf(shared + pass.code) != ReceiverKind.None);
            if (!isUrps || !receives || subShader.queue > LastOpaqueQueue) return new List<string>();
            var lacking = new List<string>();
            if (!Has(subShader, DepthOnly)) lacking.Add(DepthOnly);
            if (!Has(subShader, DepthNormals) && !Has(subShader, DepthNormals + "Only")) lacking.Add(DepthNormals);
            return lacking;
        }

        // A pass that is taken is known by its name, which in URP's shaders is that of its light mode.
        private static bool Has(SubShaderText subShader, string pass) =>
            subShader.passes.Any(own => own.lightMode == pass) ||
            subShader.takenPasses.Any(taken => taken.Equals(pass, StringComparison.OrdinalIgnoreCase));
    }
}
