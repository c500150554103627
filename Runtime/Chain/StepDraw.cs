using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Records one step of a chain, once per mip level and per cascade that was redrawn. It lives on the stack.
    /// </summary>
    internal readonly ref struct StepDraw
    {
        private readonly ShadowChain chain;
        private readonly ChainStep step;
        private readonly PassProgram program;
        private readonly RenderTargetIdentifier[] targets;
        private readonly RTHandle[] slots;
        private readonly CasterFrame casters;
        private readonly int index;

        internal StepDraw(PreparedChain prepared, int index, RTHandle[] slots, CasterFrame casters)
        {
            chain = prepared.chain;
            step = chain.Steps[index];
            program = prepared.programs[index];
            targets = prepared.targets[index];
            this.slots = slots;
            this.casters = casters;
            this.index = index;
        }

        internal void Draw(CommandBuffer commands, in ShadowFrame frame)
        {
            if (step.pass.runs == PassFrequency.Bake && !frame.storeIsEmpty) return;
            if (step.ByCascade && !frame.UpdatesAny) return;
            if (!step.pass.eachMip)
            {
                DrawCascades(commands, frame, 0);
                return;
            }
            int levels = PassGeometry.Levels(chain.Slots[step.Target], frame, step.ByCascade);
            for (int mip = 1; mip < levels; ++mip)
            {
                CopyLevel(commands, frame, mip - 1);
                commands.SetGlobalInteger(FrameUniforms.Mip, mip);
                DrawCascades(commands, frame, mip);
            }
        }

        private void DrawCascades(CommandBuffer commands, in ShadowFrame frame, int mip)
        {
            if (!step.ByCascade)
            {
                DrawOnce(commands, frame, 0, mip);
                return;
            }
            for (int cascade = 0; cascade < frame.layout.Cascades; ++cascade)
                if (frame.Updates(cascade)) DrawOnce(commands, frame, cascade, mip);
        }

        private void DrawOnce(CommandBuffer commands, in ShadowFrame frame, int cascade, int mip)
        {
            SetSizes(commands, frame, cascade, mip);
            if (step.pass.kind == PassKind.Compute) Dispatch(commands, frame);
            else if (step.pass.kind == PassKind.Casters) DrawCasters(commands, frame, cascade);
            else if (step.pass.kind == PassKind.Lit) Fill(commands, slots[step.Target], Color.white);
            else DrawTriangle(commands, frame, cascade, mip);
        }

        private void SetSizes(CommandBuffer commands, in ShadowFrame frame, int cascade, int mip)
        {
            for (int i = 0; i < step.reads.Length; ++i)
            {
                int level = step.reads[i].levels != null ? mip - 1 : 0;
                commands.SetGlobalVector(step.reads[i].sizeProperty,
                                         TextureSize.Drawn(chain.Slots[step.reads[i].index], frame).At(level).Uniform);
            }
            for (int i = 0; i < step.absentSizes.Length; ++i)
            {
                // The texture of an earlier pass or frame may still be bound under this name, and it may be this step's
                // target: OpenGL and WebGL refuse such a draw, even if the program does not read the texture.
                commands.SetGlobalTexture(step.absent[i], AbsentTexture.For(frame.views));
                commands.SetGlobalVector(step.absentSizes[i], Vector4.zero);
            }
            ChainTexture target = chain.Slots[step.threadsOf != ShadowChain.None ? step.threadsOf : step.Target];
            commands.SetGlobalVector(FrameUniforms.TargetSize, TextureSize.Drawn(target, frame).At(mip).Uniform);
            if (!step.ByCascade) return;
            Rect tile = PassGeometry.Area(target, frame, true, cascade, mip);
            commands.SetGlobalInteger(FrameUniforms.Cascade, cascade);
            commands.SetGlobalVector(FrameUniforms.Tile, new Vector4(tile.x, tile.y, tile.width, tile.height));
        }

        // Where no caster is drawn, the targets hold 0 and the depth the far plane's.
        private void DrawCasters(CommandBuffer commands, in ShadowFrame frame, int cascade)
        {
            BindReads(commands, 0);
            ChainTexture target = chain.Slots[step.Target];
            int slice = step.ByCascade && target.extent == GraphExtent.Tile ? cascade : -1;
            RenderTargetIdentifier depth = step.depth != ShadowChain.None ? slots[step.depth]
                                           : step.pass.testsShadowMap ? casters.shadowMap : slots[step.Target];
            if (targets == null)
            {
                commands.SetRenderTarget(depth, 0, CubemapFace.Unknown, slice);
            }
            else
            {
                for (int i = 0; i < targets.Length; ++i) targets[i] = slots[step.writes[i].index];
                commands.SetRenderTarget(targets, depth, 0, CubemapFace.Unknown, slice);
            }
            if (step.ByCascade && target.extent == GraphExtent.Map)
                commands.SetViewport(PassGeometry.Area(target, frame, true, cascade, 0));
            commands.ClearRenderTarget(step.depth != ShadowChain.None, targets != null, Color.clear);
            if (step.ByCascade) casters.DrawCascade(commands, index, cascade);
            else casters.Draw(commands, index);
        }

        private void BindReads(CommandBuffer commands, int mip)
        {
            for (int i = 0; i < step.reads.Length; ++i)
            {
                ChainBinding read = step.reads[i];
                commands.SetGlobalTexture(read.property,
                                          slots[read.levels == null ? read.index : read.levels[mip - 1]]);
            }
        }

        private void DrawTriangle(CommandBuffer commands, in ShadowFrame frame, int cascade, int mip)
        {
            BindReads(commands, mip);
            ChainTexture target = chain.Slots[step.Target];
            int slice = step.ByCascade && target.extent == GraphExtent.Tile ? cascade : -1;
            bool isTile = step.ByCascade && target.extent == GraphExtent.Map;
            SetTargets(commands, mip, slice, isTile);
            if (isTile) commands.SetViewport(PassGeometry.Area(target, frame, true, cascade, mip));
            commands.DrawProcedural(Matrix4x4.identity, program.asset.material, program.index, MeshTopology.Triangles, 3,
                                    1, null);
        }

        // The target is loaded where only a tile is drawn, so that the other cascades' tiles stay unchanged.
        private void SetTargets(CommandBuffer commands, int mip, int slice, bool load)
        {
            if (targets == null)
            {
                CoreUtils.SetRenderTarget(commands, slots[step.Target],
                                          load ? RenderBufferLoadAction.Load : RenderBufferLoadAction.DontCare,
                                          RenderBufferStoreAction.Store, ClearFlag.None, Color.clear, mip,
                                          CubemapFace.Unknown, slice);
                return;
            }
            for (int i = 0; i < targets.Length; ++i) targets[i] = slots[step.writes[i].index];
            // The second argument is the depth target; passing a colour target means none.
            commands.SetRenderTarget(targets, targets[0], 0, CubemapFace.Unknown, slice);
        }

        private void Dispatch(CommandBuffer commands, in ShadowFrame frame)
        {
            ComputeShader kernels = program.asset.kernels;
            if (step.IsSparse) ClearTargets(commands);
            foreach (ChainBinding read in step.reads) Bind(commands, read);
            foreach (ChainBinding write in step.writes) Bind(commands, write);
            GraphGroups groups = step.pass.groups;
            Vector3Int count = step.threadsOf == ShadowChain.None
                                   ? new Vector3Int(groups.x, groups.y, groups.z)
                                   : PassGeometry.Groups(chain.Slots[step.threadsOf], frame, step.ByCascade,
                                                         groups.divisor, program.threads);
            commands.DispatchCompute(kernels, program.index, count.x, count.y, count.z);
        }

        // Texels that the kernel does not write are 0 instead of the content of another frame. Textures that it updates
        // are kept.
        private void ClearTargets(CommandBuffer commands)
        {
            for (int i = 0; i < step.pass.writes.Length; ++i)
                Fill(commands, slots[step.writes[i].index], Color.clear);
        }

        private static void Fill(CommandBuffer commands, RTHandle target, Color colour) =>
            CoreUtils.SetRenderTarget(commands, target, RenderBufferLoadAction.DontCare, RenderBufferStoreAction.Store,
                                      ClearFlag.Color, colour);

        private void Bind(CommandBuffer commands, in ChainBinding texture) =>
            commands.SetComputeTextureParam(program.asset.kernels, program.index, texture.property,
                                            slots[texture.index]);

        // A texture cannot be read while one of its levels is drawn, so programs read a copy of the previous level.
        private void CopyLevel(CommandBuffer commands, in ShadowFrame frame, int level)
        {
            for (int i = 0; i < step.reads.Length; ++i)
            {
                ChainBinding read = step.reads[i];
                if (read.levels == null) continue;
                ChainTexture texture = chain.Slots[read.index];
                TextureSize size = TextureSize.Drawn(texture, frame).At(level);
                for (int slice = 0; slice < size.depth; ++slice)
                    commands.CopyTexture(slots[read.index], slice, level, 0, 0, size.width, size.height,
                                         slots[read.levels[level]], slice, 0, 0, 0);
            }
        }
    }
}
