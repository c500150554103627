using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEditor.Rendering;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Lists what the editor's compiler has refused of the shaders of some passes.</summary>
    internal static class ShaderErrors
    {
        private const int MostSaid = 3;

        /// <summary>The message "file, line: message" of a few errors; null if there are none.</summary>
        internal static string Of(IEnumerable<GraphPass> passes)
        {
            string[] errors = passes.Select(pass => pass.asset).Distinct().SelectMany(Of).Distinct().ToArray();
            if (errors.Length == 0) return null;
            string said = string.Join("\n", errors.Take(MostSaid));
            return errors.Length <= MostSaid ? said : said + "\nand " + (errors.Length - MostSaid) + " more";
        }

        private static IEnumerable<string> Of(string file)
        {
            var asset = AssetDatabase.LoadAssetAtPath<Object>(PassAssets.PathInProject(file));
            return Messages(asset).Where(message => message.severity == ShaderCompilerMessageSeverity.Error)
                .Select(message => Text(file, message));
        }

        private static ShaderMessage[] Messages(Object asset)
        {
            if (asset is ComputeShader kernels) return ShaderUtil.GetComputeShaderMessages(kernels);
            return asset is Shader shader ? ShaderUtil.GetShaderMessages(shader) : new ShaderMessage[0];
        }

        // The compiler names no file where the error is in the asset itself.
        private static string Text(string file, ShaderMessage message) =>
            (string.IsNullOrEmpty(message.file) ? file : message.file) + ", line " + message.line + ": " + message.message +
            " (" + message.platform + ")";
    }
}
