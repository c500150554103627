#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Switches transparents back to URP's own shadow map, in Unity 6, as the screen-space texture does not contain
    /// them. The pass draws nothing, but runs between two draws of the camera: as a raster pass on the camera's colour
    /// it stays in their native render pass. Any other kind of pass would make a tile-based GPU store and reload the
    /// image, and URP's Tile-Only Mode throws an exception for it.
    /// </summary>
    internal sealed class GraphRestorePass : ScriptableRenderPass
    {
        private sealed class PassData
        {
            internal int cascadeCount;
            internal ShadowFrame frame;
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
                data.frame = shadows.Frame;
                data.cascadeCount =
                    data.frame.overLit ? 1 : frameData.Get<UniversalShadowData>().mainLightShadowCascadesCount;
                builder.SetRenderAttachment(resources.activeColorTexture, 0, AccessFlags.Write);
                builder.AllowPassCulling(false);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc(static (PassData passData, RasterGraphContext context) =>
                                          Restore(passData, context));
            }
        }

        private static void Restore(PassData data, in RasterGraphContext context)
        {
            ShadowKeywords.Global.Restore(context.cmd, data.cascadeCount);
            ReceiverFade.Restore(context.cmd, data.frame);
        }
    }
}
#endif
