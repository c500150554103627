using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// An asset of a chain's passes: a material or a compute shader, with the keywords that it declares.
    /// </summary>
    internal sealed class ProgramAsset
    {
        internal readonly Material material;
        internal readonly ComputeShader kernels;
        private readonly LocalKeyword[] keywords;
        private readonly bool[] isOn;

        /// <param name="on">The enabled ones of the `known` keywords.</param>
        internal ProgramAsset(Object asset, Material material, IEnumerable<string> known, IReadOnlyList<string> on)
        {
            this.material = material;
            kernels = asset as ComputeShader;
            LocalKeywordSpace space = material != null ? material.shader.keywordSpace : kernels.keywordSpace;
            var declared = new List<LocalKeyword>();
            foreach (string name in known)
            {
                LocalKeyword keyword = space.FindKeyword(name);
                if (keyword.isValid) declared.Add(keyword);
            }
            keywords = declared.ToArray();
            isOn = new bool[keywords.Length];
            for (int i = 0; i < isOn.Length; ++i)
                for (int k = 0; k < on.Count; ++k) isOn[i] |= on[k] == keywords[i].name;
        }

        internal bool Declares(string keyword)
        {
            foreach (LocalKeyword declared in keywords)
                if (declared.name == keyword) return true;
            return false;
        }

        /// <summary>
        /// The problem of a pass of casters, which draws with their own materials and those materials' keywords. Null
        /// if the chain enables no keyword that the pass declares.
        /// </summary>
        internal string CasterProblem(GraphPass pass)
        {
            for (int i = 0; i < keywords.Length; ++i)
                if (isOn[i])
                    return "pass '" + pass.program + "' of " + pass.asset + " draws objects with their own materials, " +
                           "which do not enable its keyword " + keywords[i].name;
            return null;
        }

        // The command buffer sets the keywords, and not the asset, because another camera may select another technique
        // before these commands are executed.
        internal void SetKeywords(CommandBuffer commands)
        {
            for (int i = 0; i < keywords.Length; ++i)
                if (material != null) commands.SetKeyword(material, keywords[i], isOn[i]);
                else commands.SetKeyword(kernels, keywords[i], isOn[i]);
        }
    }

    /// <summary>The program that a step runs.</summary>
    internal readonly struct PassProgram
    {
        internal readonly ProgramAsset asset;

        /// <summary>The index of the material's pass, or of the kernel.</summary>
        internal readonly int index;

        /// <summary>Threads per thread group of a kernel, along each axis.</summary>
        internal readonly Vector3Int threads;

        internal PassProgram(ProgramAsset asset, int index, Vector3Int threads = default)
        {
            this.asset = asset;
            this.index = index;
            this.threads = threads;
        }
    }
}
