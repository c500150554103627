using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// Removes the variants of the shaders of passes that no feature or Volume of the project can use from players; of
    /// passes that no chain draws it removes all variants.
    /// </summary>
    internal sealed class ChainShaderStripper : IPreprocessShaders
    {
        public int callbackOrder => 0;

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            string asset = AssetOf(shader);
            if (asset != null) Strip(FeaturesInProject.Programs(), shader, asset, snippet.passName, data);
        }

        /// <summary>
        /// The path in the package of a shader of which some graph has a pass; null for other shaders.
        /// </summary>
        internal static string AssetOf(Shader shader) =>
            shader.name == PenumbraShadows.ShaderName ? PenumbraShadows.ShaderFile : AssetOf((UnityEngine.Object)shader);

        /// <summary>
        /// The path in the package of any shader or compute shader but the feature's own; null if no graph has a pass
        /// of it.
        /// </summary>
        internal static string AssetOf(UnityEngine.Object asset)
        {
            string path = AssetDatabase.GetAssetPath(asset);
            return ChainGraphs.All.SelectMany(graph => graph.passes).Select(pass => pass.asset)
                .FirstOrDefault(file => path == PassAssets.PathInProject(file));
        }

        /// <summary>Strips the variants in `data`, those of one stage of the pass.</summary>
        internal static void Strip(ChainPrograms asked, Shader shader, string asset, string pass,
                                   IList<ShaderCompilerData> data)
        {
            KeywordsOfVariants keywords = variant => name =>
                variant.shaderKeywordSet.IsEnabled(new ShaderKeyword(shader, name));
            List<string> declared = Declared(keywords, data);
            for (int i = data.Count - 1; i >= 0; --i)
                if (!asked.Has(asset, pass, declared, keywords(data[i]))) data.RemoveAt(i);
        }

        /// <summary>
        /// The chains' keywords that the variants declare. One that a stage does not declare is off in all its
        /// variants: vertex programs do not have the fragment programs' keywords.
        /// </summary>
        internal static List<string> Declared(KeywordsOfVariants keywords, IList<ShaderCompilerData> data)
        {
            var declared = new List<string>();
            foreach (string name in ChainKeywords.All)
                foreach (ShaderCompilerData variant in data)
                {
                    if (!keywords(variant)(name)) continue;
                    declared.Add(name);
                    break;
                }
            return declared;
        }
    }

    /// <summary>Whether the keyword of a name is enabled in a variant.</summary>
    internal delegate Predicate<string> KeywordsOfVariants(ShaderCompilerData variant);
}
