using System.Collections.Generic;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>Takes the variants of our own shader that no feature and no Volume of the project uses out of players.</summary>
    internal sealed class ResolveShaderStripper : IPreprocessShaders
    {
        private const string ResolvePass = "Resolve";

        public int callbackOrder => 0;

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            if (shader.name != PenumbraShadows.ShaderName || snippet.passName != ResolvePass) return;
            ResolveVariants variants = FeaturesInProject.Variants();
            for (int i = data.Count - 1; i >= 0; --i)
            {
                ShaderKeywordSet keywords = data[i].shaderKeywordSet;
                if (!variants.Uses(name => IsEnabled(shader, keywords, name))) data.RemoveAt(i);
            }
        }

        private static bool IsEnabled(Shader shader, ShaderKeywordSet keywords, string name) =>
            keywords.IsEnabled(new ShaderKeyword(shader, name));
    }
}
