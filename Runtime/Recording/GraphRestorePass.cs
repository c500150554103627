#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Unity 6: gives transparents, which the screen-space texture does not know, URP's own shadow map back. It draws
    /// nothing, but stands between two draws of the camera: as a raster pass on the camera's colour it stays in their
    /// native render pass. Any other kind of pass would have a GPU with tiles write the picture out and read it in again,
    /// and URP's Tile-Only Mode throws at it.
    /// </summary>
    internal sealed class GraphRestorePass : ScriptableRenderPass
    {
        private sealed class PassData
        {
            internal int cascadeCount;
        }

        private readonly GraphShadowPass shadows;

        internal GraphRestorePass(GraphShadowPass shadows)
        {
            this.shadows = shadows;
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
            profilingSampler = new ProfilingSampler("Penumbra Shadows Restore");
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            if (!shadows.Visibility.IsValid()) return;
            UniversalResourceData resources = frameData.Get<UniversalResourceData>();
            using (IRasterRenderGraphBuilder builder = renderGraph.AddRasterRenderPass("Penumbra Shadows Restore",
                                                                                       out PassData data,
                                                                                       profilingSampler))
            {
                data.cascadeCount = frameData.Get<UniversalShadowData>().mainLightShadowCascadesCount;
                builder.SetRenderAttachment(resources.activeColorTexture, 0, AccessFlags.Write);
                builder.AllowPassCulling(false);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc(static (PassData passData, RasterGraphContext context) =>
                                          ShadowKeywords.Global.Restore(context.cmd, passData.cascadeCount));
            }
        }
    }
}
#endif
