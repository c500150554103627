using System.Collections.Generic;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Editor
{
    /// <summary>
    /// Removes from players the kernels that no frame of the project can run. The feature's asset refers to the compute
    /// shaders of all techniques, so these are the kernels and keyword sets that no feature or Volume selects, and all
    /// kernels on graphics APIs on which DeviceLimits.IsOpenGl lets none run.
    /// </summary>
    internal sealed class ChainKernelStripper : IPreprocessComputeShaders
    {
#if PENUMBRA_XR
        private const bool DrawsBothEyes = true;
#else
        private const bool DrawsBothEyes = false;
#endif

        public int callbackOrder => 0;

        public void OnProcessComputeShader(ComputeShader shader, string kernelName, IList<ShaderCompilerData> data)
        {
            string asset = ChainShaderStripper.AssetOf(shader);
            if (asset != null) Strip(FeaturesInProject.Programs(), shader, asset, kernelName, data, DrawsBothEyes);
        }

        /// <param name="bothEyes">Whether the project has XR, which can draw both eyes at once.</param>
        internal static void Strip(ChainPrograms asked, ComputeShader shader, string asset, string kernel,
                                   IList<ShaderCompilerData> data, bool bothEyes)
        {
            KeywordsOfVariants keywords = variant => name =>
                variant.shaderKeywordSet.IsEnabled(new ShaderKeyword(shader, name));
            List<string> declared = ChainShaderStripper.Declared(keywords, data);
            // The project draws one eye with and without XR.
            declared.Remove(ChainKeywords.BothEyes);
            for (int i = data.Count - 1; i >= 0; --i)
                if (IsOpenGl(data[i].shaderCompilerPlatform) ||
                    !bothEyes && keywords(data[i])(ChainKeywords.BothEyes) ||
                    !asked.Has(asset, kernel, declared, keywords(data[i]))) data.RemoveAt(i);
        }

        private static bool IsOpenGl(ShaderCompilerPlatform platform) =>
#if UNITY_6000_0_OR_NEWER
            platform == ShaderCompilerPlatform.WebGPU ||
#endif
            platform == ShaderCompilerPlatform.GLES3x || platform == ShaderCompilerPlatform.OpenGLCore;
    }
}
