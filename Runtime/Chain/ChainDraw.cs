using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Draws a chain with one material: the same for both of URP's ways to record a frame. Allocates when the chain
    /// changes, not while it draws.
    /// </summary>
    internal sealed class ChainDraw
    {
        private readonly FrameUniforms uniforms = new FrameUniforms();
        private readonly Material material;
        private readonly LocalKeyword[] keywords = new LocalKeyword[TechniqueKeywords.All.Length];
        private readonly bool[] isOn = new bool[TechniqueKeywords.All.Length];
        private readonly List<int> shaderPasses = new List<int>();
        private ShadowOptions chainOptions;

        /// <summary>Its textures and draws; null before the first Prepare.</summary>
        internal ShadowChain Chain { get; private set; }

        internal ChainDraw(Material material)
        {
            this.material = material;
            for (int i = 0; i < keywords.Length; ++i)
                keywords[i] = new LocalKeyword(material.shader, TechniqueKeywords.All[i]);
        }

        /// <summary>Makes the chain for these options, if it is not the one there is.</summary>
        internal void Prepare(in ShadowOptions options)
        {
            if (Chain != null && chainOptions.Equals(options)) return;
            Chain = ShadowChain.Of(options, ShadowPassList.All);
            chainOptions = options;
            shaderPasses.Clear();
            foreach (ChainStep step in Chain.Steps) shaderPasses.Add(material.FindPass(step.shaderPass));
            for (int i = 0; i < isOn.Length; ++i) isOn[i] = Chain.Keywords.Contains(TechniqueKeywords.All[i]);
        }

        /// <summary>`slots` in the order of Chain.Slots.</summary>
        internal void Draw(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots)
        {
            uniforms.Set(commands, frame);
            SetKeywords(commands);
            for (int i = 0; i < Chain.Passes.Count; ++i) Chain.Passes[i].SetUniforms(commands, frame);
            for (int i = 0; i < Chain.Steps.Count; ++i) Draw(commands, frame, slots, i);
        }

        // By the command buffer, not on the material: another camera may want another technique before this one's
        // commands have run.
        private void SetKeywords(CommandBuffer commands)
        {
            for (int i = 0; i < keywords.Length; ++i) commands.SetKeyword(material, keywords[i], isOn[i]);
        }

        private void Draw(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots, int index)
        {
            ChainStep step = Chain.Steps[index];
            if (step.mask != ShadowChain.None) commands.SetGlobalTexture(FrameUniforms.MaskTexture, slots[step.mask]);
            if (step.source != ShadowChain.None)
            {
                commands.SetGlobalTexture(FrameUniforms.SourceTexture, slots[step.source]);
                commands.SetGlobalVector(FrameUniforms.SourceSize,
                                         FrameUniforms.Size(frame, Chain.Slots[step.source]));
            }
            commands.SetGlobalVector(FrameUniforms.TargetSize,
                                     FrameUniforms.Size(frame, Chain.Slots[step.target]));
            CoreUtils.SetRenderTarget(commands, slots[step.target], RenderBufferLoadAction.DontCare,
                                      RenderBufferStoreAction.Store, ClearFlag.None, Color.clear);
            commands.DrawProcedural(Matrix4x4.identity, material, shaderPasses[index], MeshTopology.Triangles, 3, 1,
                                    null);
        }
    }
}
