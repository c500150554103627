using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Records a chain, its draws with one material: the same for both of URP's ways to record a frame. Allocates when
    /// the chain changes, not while it draws.
    /// </summary>
    internal sealed class ChainDraw
    {
        private readonly FrameUniforms uniforms = new FrameUniforms();
        private readonly Material material;
        private readonly IReadOnlyList<ShadowPass> available;
        private readonly LocalKeyword[] keywords;
        private readonly bool[] isOn;
        private readonly List<int> shaderPasses = new List<int>();
        private ShadowOptions chainOptions;

        /// <summary>Its textures and draws; null before the first Prepare.</summary>
        internal ShadowChain Chain { get; private set; }

        internal ChainDraw(Material material) : this(material, ShadowPassList.All, ChainKeywords.All) { }

        internal ChainDraw(Material material, IReadOnlyList<ShadowPass> available, IReadOnlyList<string> declared)
        {
            this.material = material;
            this.available = available;
            keywords = declared.Select(name => new LocalKeyword(material.shader, name)).ToArray();
            isOn = new bool[keywords.Length];
        }

        /// <summary>Makes the chain for these options, if it is not the one there is.</summary>
        internal void Prepare(in ShadowOptions options)
        {
            if (Chain != null && chainOptions.Equals(options)) return;
            Chain = ShadowChain.Of(options, available);
            chainOptions = options;
            shaderPasses.Clear();
            foreach (ChainStep step in Chain.Steps)
                shaderPasses.Add(step.recorder == null ? material.FindPass(step.shaderPass) : ShadowChain.None);
            for (int i = 0; i < isOn.Length; ++i) isOn[i] = Chain.Keywords.Contains(keywords[i].name);
        }

        /// <summary>`slots` in the order of Chain.Slots.</summary>
        internal void Draw(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots)
        {
            uniforms.Set(commands, frame);
            SetKeywords(commands);
            for (int i = 0; i < Chain.Passes.Count; ++i) Chain.Passes[i].SetUniforms(commands, frame);
            for (int i = 0; i < Chain.Steps.Count; ++i)
            {
                Take(commands, frame, slots, i);
                Publish(commands, slots, i);
            }
        }

        // By the command buffer, not on the material: another camera may want another technique before this one's
        // commands have run.
        private void SetKeywords(CommandBuffer commands)
        {
            for (int i = 0; i < keywords.Length; ++i) commands.SetKeyword(material, keywords[i], isOn[i]);
        }

        private void Take(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots, int index)
        {
            ChainStep step = Chain.Steps[index];
            if (step.source != ShadowChain.None)
            {
                commands.SetGlobalTexture(FrameUniforms.SourceTexture, slots[step.source]);
                commands.SetGlobalVector(FrameUniforms.SourceSize,
                                         FrameUniforms.Size(frame, Chain.Slots[step.source]));
            }
            commands.SetGlobalVector(FrameUniforms.TargetSize,
                                     FrameUniforms.Size(frame, Chain.Slots[step.target]));
            if (step.recorder != null)
            {
                step.recorder.Record(commands, frame, slots[step.target], step.run);
                return;
            }
            CoreUtils.SetRenderTarget(commands, slots[step.target], RenderBufferLoadAction.DontCare,
                                      RenderBufferStoreAction.Store, ClearFlag.None, Color.clear);
            commands.DrawProcedural(Matrix4x4.identity, material, shaderPasses[index], MeshTopology.Triangles, 3, 1,
                                    null);
        }

        private void Publish(CommandBuffer commands, RTHandle[] slots, int step)
        {
            for (int i = 0; i < Chain.Globals.Count; ++i)
                if (Chain.Globals[i].afterStep == step)
                    commands.SetGlobalTexture(Chain.Globals[i].property, slots[Chain.Globals[i].texture]);
        }
    }
}
