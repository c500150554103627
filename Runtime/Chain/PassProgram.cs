using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>An asset of a chain's passes: a material, or a compute shader, and the keywords that it declares.</summary>
    internal sealed class ProgramAsset
    {
        internal readonly Material material;
        internal readonly ComputeShader kernels;
        private readonly LocalKeyword[] keywords;
        private readonly bool[] isOn;

        /// <param name="on">Of the `known` keywords those that are on.</param>
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

        /// <summary>
        /// Casters have their own materials and the keywords of these. Null: none of the chain's is missed.
        /// </summary>
        internal string CasterProblem(GraphPass pass)
        {
            for (int i = 0; i < keywords.Length; ++i)
                if (isOn[i])
                    return "pass '" + pass.program + "' of " + pass.asset + " draws objects with their own materials, " +
                           "on which keyword " + keywords[i].name + " is not";
            return null;
        }

        // By the command buffer, not on the asset: another camera may want another technique before this one's commands
        // have run.
        internal void SetKeywords(CommandBuffer commands)
        {
            for (int i = 0; i < keywords.Length; ++i)
                if (material != null) commands.SetKeyword(material, keywords[i], isOn[i]);
                else commands.SetKeyword(kernels, keywords[i], isOn[i]);
        }
    }

    /// <summary>What a step runs.</summary>
    internal readonly struct PassProgram
    {
        internal readonly ProgramAsset asset;

        /// <summary>The pass of the material, or the kernel.</summary>
        internal readonly int index;

        /// <summary>Of a kernel's group, along each axis.</summary>
        internal readonly Vector3Int threads;

        internal PassProgram(ProgramAsset asset, int index, Vector3Int threads = default)
        {
            this.asset = asset;
            this.index = index;
            this.threads = threads;
        }
    }
}
