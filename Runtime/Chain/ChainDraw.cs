using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Records a chain into a command buffer, the same with and without the render graph. It allocates when options
    /// first need a chain, but not while it draws.
    /// </summary>
    internal sealed class ChainDraw : IDisposable
    {
        private readonly FrameUniforms uniforms = new FrameUniforms();
        private readonly PassMaterials materials;
        private readonly Dictionary<(int key, bool bothEyes, bool overLit), PreparedChain> chains =
            new Dictionary<(int key, bool bothEyes, bool overLit), PreparedChain>();
        private PreparedChain current;

        /// <summary>
        /// The number of times that the editor has imported shaders: a chain that was prepared from earlier ones, which
        /// may have failed to compile, is prepared again.
        /// </summary>
        internal static int Imports { get; set; }
        private int importsBefore;

        /// <summary>The current chain's textures and steps; null before the first Prepare.</summary>
        internal ShadowChain Chain => current?.chain;

        internal ChainDraw(Material material, PassAssets assets) => materials = new PassMaterials(material, assets);

        /// <summary>
        /// The reason why the current chain stands in for the one that was asked for; null if it does not.
        /// </summary>
        internal string Replaces => current?.replaces;

        /// <summary>
        /// Selects the chain for these options, and changes them to those that this device can draw. Returns what
        /// prevents it from running, or null.
        /// </summary>
        /// <param name="views">Number of views drawn at once.</param>
        /// <param name="overLit">Nothing casts into the cascades: only what lies beyond them is drawn.</param>
        internal string Prepare(ref ShadowOptions options, int views, bool overLit = false)
        {
            if (importsBefore != Imports) chains.Clear();
            importsBefore = Imports;
            bool bothEyes = views > 1;
            (int, bool, bool) key = (ChainGraphs.Key(options), bothEyes, overLit);
            if (!chains.TryGetValue(key, out current)) chains[key] = current = Prepared(options, bothEyes, overLit);
            if (current.replaces != null) options = current.Of(options);
            return current.problem;
        }

        private PreparedChain Prepared(in ShadowOptions asked, bool bothEyes, bool overLit)
        {
            var prepared = new PreparedChain(asked, bothEyes, overLit, materials);
            ShadowOptions options = asked;
            while (prepared.problem != null && ChainSubstitute.TryGet(options, out options))
                prepared = new PreparedChain(options, bothEyes, overLit, materials, prepared.replaces ?? prepared.problem);
            return prepared;
        }

        /// <summary>The program of a step of the chain.</summary>
        internal ref readonly PassProgram Program(int step) => ref current.programs[step];

        /// <summary>Draws the chain; `slots` are in its order.</summary>
        /// <param name="casters">For chains that draw objects: the frame's casters and their lists.</param>
        internal void Draw(CommandBuffer commands, in ShadowFrame frame, RTHandle[] slots, CasterFrame casters = null)
        {
#if UNITY_EDITOR
            // Until a program is compiled the editor would skip its draws, and the targets would keep what they held.
            UnityEditor.ShaderUtil.SetAsyncCompilation(commands, false);
#endif
            uniforms.Set(commands, frame);
            for (int i = 0; i < current.assets.Length; ++i) current.assets[i].SetKeywords(commands);
            if (frame.historiesAreEmpty) ClearHistories(commands, frame, slots);
            for (int i = 0; i < Chain.Steps.Count; ++i)
            {
                // Eyes drawn at once are two instances of a draw, in two slices of the target.
                bool oneView = frame.views > 1 && Chain.Steps[i].pass.kind != PassKind.Compute &&
                               !Chain.IsOverScreen(Chain.Steps[i]);
                if (oneView) frame.xr.StopSinglePass(commands);
                var step = new StepDraw(current, i, slots, casters);
                step.Draw(commands, frame);
                if (oneView) frame.xr.StartSinglePass(commands);
                Publish(commands, frame, slots, i);
            }
            FrameUniforms.StopNoise(commands, frame);
#if UNITY_EDITOR
            UnityEditor.ShaderUtil.RestoreAsyncCompilation(commands);
#endif
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

        /// <summary>Releases the chains; later ones are built from the assets that exist then.</summary>
        public void Dispose()
        {
            chains.Clear();
            current = null;
            materials.Dispose();
        }
    }
}
