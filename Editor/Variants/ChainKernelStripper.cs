using System.Collections.Generic;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// Removes the kernels of passes that no feature or Volume of the project can use from players: the feature's asset
    /// refers to all compute shaders of all techniques.
    /// </summary>
    internal sealed class ChainKernelStripper : IPreprocessComputeShaders
    {
        public int callbackOrder => 0;

        public void OnProcessComputeShader(ComputeShader shader, string kernelName, IList<ShaderCompilerData> data)
        {
            string asset = ChainShaderStripper.AssetOf(shader);
            if (asset != null) Strip(FeaturesInProject.Programs(), asset, kernelName, data);
        }

        internal static void Strip(ChainPrograms asked, string asset, string kernel, IList<ShaderCompilerData> data)
        {
            if (!asked.HasKernel(asset, kernel)) data.Clear();
        }
    }
}
