using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Records a chain: the same for both of URP's ways to record a frame. Allocates for options that need a chain which
    /// none before them did, not while it draws.
    /// </summary>
    internal sealed class ChainDraw : IDisposable
    {
        private readonly FrameUniforms uniforms = new FrameUniforms();
        private readonly PassMaterials materials;
        private readonly Dictionary<int, PreparedChain> chains = new Dictionary<int, PreparedChain>();
        private PreparedChain current;

        /// <summary>Its textures and steps; null before the first Prepare.</summary>
        internal ShadowChain Chain => current?.chain;

        internal ChainDraw(Material material, PassAssets assets)
        {
            materials = new PassMaterials(material, assets);
        }

        /// <summary>Chooses the chain of these options. Returns what it lacks to run; null: nothing.</summary>
        /// <param name="views">Drawn at once.</param>
        internal string Prepare(in ShadowOptions options, int views)
        {
            int key = ChainGraphs.Key(options);
            if (!chains.TryGetValue(key, out current))
                chains[key] = current = new PreparedChain(ShadowChain.Of(options), materials);
            return current.problem ?? (views > 1 ? current.stereoProblem : null);
        }

        /// <summary>Of a step of the chain.</summary>
        internal ref readonly PassProgram Program(int step) => ref current.programs[step];

        /// <summary>`slots` and `buffers` in the order of the chain's.</summary>
        /// <param name="casters">Of chains that draw objects, with its lists.</param>
        internal void Draw(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots, GraphicsBuffer[] buffers,
                           CasterFrame casters = null)
        {
            uniforms.Set(commands, frame);
            for (int i = 0; i < current.assets.Length; ++i) current.assets[i].SetKeywords(commands);
            if (frame.historiesAreEmpty) ClearHistories(commands, frame, slots);
            for (int i = 0; i < Chain.Steps.Count; ++i)
            {
                // Eyes that are drawn at once are two instances of a draw and two slices of the target.
                bool oneView = frame.views > 1 && Chain.Steps[i].pass.kind != PassKind.Compute &&
                               !Chain.IsOverScreen(Chain.Steps[i]);
                if (oneView) frame.xr.StopSinglePass(commands);
                var step = new StepDraw(current, i, slots, buffers, casters);
                step.Draw(commands, frame);
                if (oneView) frame.xr.StartSinglePass(commands);
                Publish(commands, frame, slots, i);
            }
        }

        private void ClearHistories(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots)
        {
            for (int i = 0; i < Chain.Histories.Count; ++i)
            {
                int before = Chain.Histories[i].before;
                int levels = PassGeometry.Levels(Chain.Slots[before], frame, false);
                for (int mip = 0; mip < levels; ++mip)
                    CoreUtils.SetRenderTarget(commands, slots[before], RenderBufferLoadAction.DontCare,
                                              RenderBufferStoreAction.Store, ClearFlag.Color, Color.clear, mip);
            }
        }

        private void Publish(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots, int step)
        {
            for (int i = 0; i < Chain.Globals.Count; ++i)
            {
                if (Chain.Globals[i].afterStep != step) continue;
                ChainBinding texture = Chain.Globals[i].texture;
                commands.SetGlobalTexture(texture.property, slots[texture.index]);
                commands.SetGlobalVector(texture.sizeProperty,
                                         TextureSize.Drawn(Chain.Slots[texture.index], frame).Uniform);
            }
        }

        /// <summary>Chains are made anew of the assets that there are then.</summary>
        public void Dispose()
        {
            chains.Clear();
            current = null;
            materials.Dispose();
        }
    }
}
