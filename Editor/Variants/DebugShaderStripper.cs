using System.Collections.Generic;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Removes the debug views from release players.</summary>
    internal sealed class DebugShaderStripper : IPreprocessShaders
    {
        public int callbackOrder => 0;

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            if (Removes(shader.name, PlayerBuild.IsDevelopment)) data.Clear();
        }

        internal static bool Removes(string shaderName, bool development) =>
            shaderName == DebugViewDraw.ShaderName && !development;
    }
}
