#if UNITY_6000_0_OR_NEWER
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Draws the chain and makes receivers read its texture, in Unity 6. It is one unsafe pass, because its draws
    /// change render targets, which a raster pass cannot do. So it must not run between two draws of the camera: it
    /// runs right after the depth prepass, before anything is drawn to the camera's colour, including XR's occlusion
    /// mesh. One event works for every rendering path: a depth request there gives all of them a full depth prepass,
    /// and deferred keeps its G-buffer and lighting in one native pass.
    /// </summary>
    internal sealed class GraphShadowPass : ScriptableRenderPass
    {
        private sealed class PassData
        {
            internal TextureHandle[] textures = new TextureHandle[0];
            internal RTHandle[] slots = new RTHandle[0];
            internal CameraStore store;
            internal ChainDraw draw;
            internal ShadowFrame frame;
            internal readonly CasterFrame casters = new CasterFrame();
            internal RendererListHandle[] lists = new RendererListHandle[0];
            internal TextureHandle shadowMap;

            // Cameras with different chains use these arrays in turn, so the arrays only grow.
            internal void MakeRoom(int slotCount, int listCount)
            {
                if (lists.Length < listCount) lists = new RendererListHandle[listCount];
                if (slots.Length >= slotCount) return;
                textures = new TextureHandle[slotCount];
                slots = new RTHandle[slotCount];
            }
        }

        private readonly CameraStores stores = new CameraStores();
        private ChainDraw draw;
        private ShadowFrame frame;
        private ScriptableRenderContext context;
        private Camera begun;

        /// <summary>The texture of the camera being recorded; not valid if nothing is drawn.</summary>
        internal TextureHandle Visibility { get; private set; }

        /// <summary>The mask of that camera; not valid without a mask.</summary>
        internal TextureHandle Mask { get; private set; }

        internal bool IsOverlay => frame.overlay;
        internal ref readonly ShadowOptions Options => ref frame.options;
        internal ref readonly ShadowFrame Frame => ref frame;

        internal GraphShadowPass()
        {
            renderPassEvent = RenderPassEvent.AfterRenderingPrePasses + 1;
            profilingSampler = new ProfilingSampler("Penumbra Shadows");
            RenderPipelineManager.beginCameraRendering += Begin;
            RenderPipelineManager.endCameraRendering += End;
        }

        // Recording has no context to cull with. The event beginCameraRendering has one, which is valid until the
        // camera ends.
        private void Begin(ScriptableRenderContext ofCamera, Camera camera)
        {
            context = ofCamera;
            begun = camera;
        }

        private void End(ScriptableRenderContext ofCamera, Camera camera) => begun = null;

        internal void Setup(ChainDraw draw, in ShadowFrame frame)
        {
            this.draw = draw;
            this.frame = frame;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalCameraData camera = frameData.Get<UniversalCameraData>();
            UniversalResourceData resources = frameData.Get<UniversalResourceData>();
            Visibility = Mask = default;
            if (!UrpFrame.TrySetCamera(ref frame, ref camera)) return;
            using (IUnsafeRenderGraphBuilder builder =
                       renderGraph.AddUnsafePass("Penumbra Shadows", out PassData data, profilingSampler))
            {
                RenderTextureDescriptor target = camera.cameraTargetDescriptor;
                CameraStore store = stores.Of(camera.camera, camera.xr.multipassId);
                store.Prepare(draw.Chain, target, ref frame);
                store.SetPreviousScreen(ref frame);
                data.draw = draw;
                data.frame = frame;
                data.store = store;
                data.MakeRoom(draw.Chain.Slots.Count,
                              draw.Chain.DrawsObjects ? draw.Chain.Steps.Count * CasterFrame.MostCascades : 0);
                for (int i = 0; i < draw.Chain.Slots.Count; ++i)
                {
                    data.textures[i] = draw.Chain.Slots[i].IsOwned ? renderGraph.ImportTexture(store.Textures[i])
                                                                   : Lent(renderGraph, target, i);
                    builder.UseTexture(data.textures[i], AccessFlags.ReadWrite);
                }
                Visibility = data.textures[ShadowChain.Output];
                if (draw.Chain.Mask != ShadowChain.None) Mask = data.textures[draw.Chain.Mask];
                if (resources.cameraDepthTexture.IsValid()) builder.UseTexture(resources.cameraDepthTexture);
                if (resources.mainShadowsTexture.IsValid()) builder.UseTexture(resources.mainShadowsTexture);
                builder.SetGlobalTextureAfterPass(data.textures[ShadowChain.Output],
                                                  FrameUniforms.ScreenSpaceShadowmap);
                // Without this the graph would give the textures' memory to later passes.
                for (int i = 0; i < draw.Chain.Globals.Count; ++i)
                {
                    ChainBinding texture = draw.Chain.Globals[i].texture;
                    builder.SetGlobalTextureAfterPass(data.textures[texture.index], texture.property);
                }
                data.shadowMap = resources.mainShadowsTexture;
                if (draw.Chain.DrawsObjects) ListCasters(renderGraph, builder, frameData, data);
                builder.AllowPassCulling(false);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc(static (PassData passData, UnsafeGraphContext context) =>
                                          Execute(passData, context));
            }
        }

        private void ListCasters(RenderGraph renderGraph, IUnsafeRenderGraphBuilder builder,
                                 ContextContainer frameData, PassData data)
        {
            UniversalCameraData camera = frameData.Get<UniversalCameraData>();
            UniversalLightData lights = frameData.Get<UniversalLightData>();
            CasterFrame casters = data.casters;
            casters.camera = camera.camera;
            casters.cameraView = camera.GetViewMatrix();
            casters.cameraProjection = camera.GetProjectionMatrix();
            casters.seen = frameData.Get<UniversalRenderingData>().cullResults;
            casters.light = lights.visibleLights[lights.mainLightIndex];
            for (int cascade = 0; cascade < CasterFrame.MostCascades; ++cascade) casters.cascades[cascade].isCulled = false;
            if (draw.Chain.DrawsCascades && begun == camera.camera)
                CasterCulling.Cull(context, casters, lights.mainLightIndex, frameData.Get<UniversalShadowData>(), frame);
            for (int step = 0; step < draw.Chain.Steps.Count; ++step)
                for (int cascade = 0; cascade < CasterFrame.MostCascades; ++cascade)
                {
                    ref RendererListHandle list = ref data.lists[CasterFrame.IndexOf(step, cascade)];
                    list = default;
                    if (!CasterCulling.TryList(casters, draw.Chain.Steps[step], cascade, draw.Program(step),
                                               out RendererListParams casting)) continue;
                    list = renderGraph.CreateRendererList(casting);
                    builder.UseRendererList(list);
                }
        }

        private TextureHandle Lent(RenderGraph renderGraph, in RenderTextureDescriptor target, int slot) =>
            UniversalRenderer.CreateRenderGraphTexture(renderGraph,
                                                       UrpFrame.Texture(target, draw.Chain.Slots[slot], frame),
                                                       draw.Chain.SlotNames[slot], false, FilterMode.Bilinear);

        private static void Execute(PassData data, UnsafeGraphContext context)
        {
            CommandBuffer commands = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
            for (int i = 0; i < data.draw.Chain.Slots.Count; ++i) data.slots[i] = data.textures[i];
            if (data.draw.Chain.DrawsObjects) TakeLists(data);
            ReceiverFade.Stop(commands, data.frame);
            data.draw.Draw(commands, data.frame, data.slots, data.casters);
            data.store.SetFilled(data.frame);
            ShadowKeywords.Global.Open(commands);
        }

        // The graph creates the lists of these handles just before the pass.
        private static void TakeLists(PassData data)
        {
            data.casters.shadowMap = data.shadowMap.IsValid() ? data.shadowMap : null;
            data.casters.MakeRoom(data.draw.Chain.Steps.Count);
            for (int i = 0; i < data.draw.Chain.Steps.Count * CasterFrame.MostCascades; ++i)
                if (data.lists[i].IsValid()) data.casters.Set(i, data.lists[i]);
        }

        internal void Dispose()
        {
            RenderPipelineManager.beginCameraRendering -= Begin;
            RenderPipelineManager.endCameraRendering -= End;
            begun = null;
            stores.Dispose();
        }
    }
}
#endif
