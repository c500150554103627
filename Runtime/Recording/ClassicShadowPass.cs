#if !UNITY_6000_0_OR_NEWER
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>Draws the chain and makes receivers read its texture, in URP 14.</summary>
    internal sealed class ClassicShadowPass : ScriptableRenderPass
    {
        private readonly CameraStores stores = new CameraStores();

        // Textures that no camera owns are shared by all cameras with the same size and chain, each of which redraws
        // them. They have keys, so that alternating cameras do not reallocate; they are released after a few frames, so
        // that resizing a window leaves no unused ones.
        private const int SharedIdleFrames = 8;
        private readonly RecentlyUsed<(ShadowChain chain, int width, int height, int slices), SlotTextures> shared =
            new RecentlyUsed<(ShadowChain chain, int width, int height, int slices), SlotTextures>(SharedIdleFrames);
        private RTHandle[] slots = new RTHandle[0];
        private readonly CasterFrame casters = new CasterFrame();
        private CameraStore store;
        private ChainDraw draw;
        private ShadowFrame frame;

        /// <summary>Whether the camera of the last Setup has drawn; its textures stay bound.</summary>
        internal bool HasDrawn { get; private set; }
        internal bool IsOverlay => frame.overlay;
        internal bool HasMask => draw.Chain.Mask != ShadowChain.None;
        internal ref readonly ShadowOptions Options => ref frame.options;
        internal ref readonly ShadowFrame Frame => ref frame;

        internal ClassicShadowPass() => profilingSampler = new ProfilingSampler("Penumbra Shadows");

        internal void Setup(ChainDraw draw, in ShadowFrame frame)
        {
            this.draw = draw;
            this.frame = frame;
            HasDrawn = false;
        }

        /// <summary>
        /// Forward has a depth prepass if depth is requested no later than the G-buffer's event; overlay cameras of a
        /// deferred renderer run forward and are treated alike. Deferred has depth after its G-buffer, and with
        /// normals requested that depth also contains objects that are drawn forward.
        /// </summary>
        internal void SetPath(bool deferred)
        {
            renderPassEvent = deferred ? RenderPassEvent.AfterRenderingGbuffer : RenderPassEvent.BeforeRenderingGbuffer;
            ConfigureInput(deferred ? ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Normal
                                    : ScriptableRenderPassInput.Depth);
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            ref CameraData camera = ref renderingData.cameraData;
            RenderTextureDescriptor target = camera.cameraTargetDescriptor;
            ShadowChain chain = draw.Chain;
            UrpFrame.SetSize(ref frame, target);
            store = stores.Of(camera.camera, camera.xr.multipassId);
            store.Prepare(chain, target, ref frame);
            if (slots.Length < chain.Slots.Count) slots = new RTHandle[chain.Slots.Count];
            SlotTextures ofSize = shared.Of((chain, target.width, target.height, target.volumeDepth));
            ofSize.MakeRoom(chain.Slots.Count);
            for (int i = 0; i < chain.Slots.Count; ++i)
                slots[i] = chain.Slots[i].IsOwned ? store.Textures[i] : Shared(ofSize, i, target);
            // This tells the renderer what the last draw leaves bound; otherwise it would not bind its own targets
            // again.
            ConfigureTarget(slots[ShadowChain.Output]);
            ConfigureClear(ClearFlag.None, Color.white);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (!UrpFrame.TrySetCamera(ref frame, ref renderingData.cameraData)) return;
            store.SetPreviousScreen(ref frame);
            CommandBuffer commands = CommandBufferPool.Get();
            using (new ProfilingScope(commands, profilingSampler))
            {
                if (draw.Chain.DrawsObjects) ListCasters(context, ref renderingData);
                ReceiverFade.Stop(commands, frame);
                draw.Draw(commands, frame, slots, casters);
                store.SetFilled(frame);
                commands.SetGlobalTexture(FrameUniforms.ScreenSpaceShadowmap, slots[ShadowChain.Output]);
                ShadowKeywords.Global.Open(commands);
            }
            context.ExecuteCommandBuffer(commands);
            CommandBufferPool.Release(commands);
            HasDrawn = true;
        }

        private void ListCasters(ScriptableRenderContext context, ref RenderingData data)
        {
            casters.camera = data.cameraData.camera;
            casters.cameraView = data.cameraData.GetViewMatrix();
            casters.cameraProjection = data.cameraData.GetProjectionMatrix();
            casters.seen = data.cullResults;
            casters.light = data.lightData.visibleLights[data.lightData.mainLightIndex];
            casters.MakeRoom(draw.Chain.Steps.Count);
            if (draw.Chain.DrawsCascades)
                CasterCulling.Cull(context, casters, data.lightData.mainLightIndex, data.shadowData, frame);
            for (int step = 0; step < draw.Chain.Steps.Count; ++step)
                for (int cascade = 0; cascade < CasterFrame.MostCascades; ++cascade)
                    if (CasterCulling.TryList(casters, draw.Chain.Steps[step], cascade, draw.Program(step),
                                              out RendererListParams list))
                        casters.Set(CasterFrame.IndexOf(step, cascade), context.CreateRendererList(ref list));
        }

        private RTHandle Shared(SlotTextures textures, int slot, in RenderTextureDescriptor target)
        {
            textures.Allocate(slot, UrpFrame.Texture(target, draw.Chain.Slots[slot], frame),
                              draw.Chain.SlotNames[slot]);
            return textures[slot];
        }

        internal void Dispose()
        {
            shared.Dispose();
            slots = new RTHandle[0];
            stores.Dispose();
        }
    }
}
#endif
