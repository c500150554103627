#if !UNITY_6000_0_OR_NEWER
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>URP 14: draws the chain and switches receivers to its texture.</summary>
    internal sealed class ClassicShadowPass : ScriptableRenderPass
    {
        private readonly RTHandle[] slots = new RTHandle[ShadowChain.SlotNames.Length];
        private ChainDraw draw;
        private ShadowFrame frame;

        /// <summary>For the camera of the last Setup; what it has drawn stays bound.</summary>
        internal bool HasDrawn { get; private set; }
        internal bool IsOverlay => frame.overlay;
        internal bool HasMask => draw.Chain.Published(MaskPass.Texture) != ShadowChain.None;
        internal ref readonly ShadowOptions Options => ref frame.options;

        internal ClassicShadowPass()
        {
            profilingSampler = new ProfilingSampler("Penumbra Shadows");
        }

        internal void Setup(ChainDraw draw, in ShadowFrame frame)
        {
            this.draw = draw;
            this.frame = frame;
            HasDrawn = false;
        }

        /// <summary>
        /// Forward has a depth prepass where depth is asked for no later than the G-buffer's place; a deferred renderer's
        /// overlay cameras run forward and are judged like the others. Deferred has its G-buffer's depth after it, and
        /// asked for normals also that of what is drawn forward there.
        /// </summary>
        internal void SetPath(bool deferred)
        {
            renderPassEvent =
                deferred ? RenderPassEvent.AfterRenderingGbuffer : RenderPassEvent.BeforeRenderingGbuffer;
            ConfigureInput(deferred ? ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Normal
                                    : ScriptableRenderPassInput.Depth);
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            RenderTextureDescriptor target = renderingData.cameraData.cameraTargetDescriptor;
            for (int i = 0; i < draw.Chain.Slots.Count; ++i)
                RenderingUtils.ReAllocateIfNeeded(ref slots[i], UrpFrame.Texture(target, draw.Chain.Slots[i], frame),
                                                  FilterMode.Bilinear, TextureWrapMode.Clamp,
                                                  name: ShadowChain.SlotNames[i]);
            Release(draw.Chain.Slots.Count);
            // The renderer has to know what the last draw leaves bound, or it does not bind its own again.
            ConfigureTarget(slots[ShadowChain.Output]);
            ConfigureClear(ClearFlag.None, Color.white);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (!UrpFrame.TrySetCamera(ref frame, ref renderingData.cameraData)) return;
            CommandBuffer commands = CommandBufferPool.Get();
            using (new ProfilingScope(commands, profilingSampler))
            {
                draw.Draw(commands, frame, slots);
                commands.SetGlobalTexture(FrameUniforms.ScreenSpaceShadowmap, slots[ShadowChain.Output]);
                ShadowKeywords.Global.Open(commands);
            }
            context.ExecuteCommandBuffer(commands);
            CommandBufferPool.Release(commands);
            HasDrawn = true;
        }

        internal void Dispose() => Release(0);

        private void Release(int first)
        {
            for (int i = first; i < slots.Length; ++i)
            {
                slots[i]?.Release();
                slots[i] = null;
            }
        }
    }
}
#endif
