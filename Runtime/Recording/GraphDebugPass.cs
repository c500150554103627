#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>Draws a debug view over the camera's image, in Unity 6.</summary>
    internal sealed class GraphDebugPass : ScriptableRenderPass
    {
        private sealed class PassData
        {
            internal DebugViewDraw draw;
            internal DebugView view;
            internal bool hasMask;
            internal bool overlay;
            internal TextureHandle picture;
        }

        private readonly GraphShadowPass shadows;
        private DebugViewDraw draw;

        internal GraphDebugPass(GraphShadowPass shadows)
        {
            this.shadows = shadows;
            // Gizmos come between the transparents and post-processing.
            renderPassEvent = RenderPassEvent.AfterRenderingTransparents;
            profilingSampler = new ProfilingSampler("Penumbra Debug View");
#if !UNITY_6000_5_OR_NEWER
            // The camera then renders to a texture instead of the back buffer, whose rows run in the opposite direction
            // on some devices. Later versions report the direction, and their Tile-Only Mode has only the back buffer.
            requiresIntermediateTexture = true;
#endif
        }

        internal void Setup(DebugViewDraw draw) { this.draw = draw; }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            if (!shadows.Visibility.IsValid()) return;
            UniversalResourceData resources = frameData.Get<UniversalResourceData>();
            using (IRasterRenderGraphBuilder builder =
                       renderGraph.AddRasterRenderPass("Penumbra Debug View", out PassData data, profilingSampler))
            {
                data.draw = draw;
                data.view = shadows.Options.debugView;
                data.hasMask = shadows.Mask.IsValid();
                data.overlay = shadows.IsOverlay;
                data.picture = resources.activeColorTexture;
                builder.SetRenderAttachment(data.picture, 0, AccessFlags.Write);
                builder.UseTexture(shadows.Visibility, AccessFlags.Read);
                if (data.hasMask) builder.UseTexture(shadows.Mask, AccessFlags.Read);
                if (resources.cameraDepthTexture.IsValid()) builder.UseTexture(resources.cameraDepthTexture);
                if (resources.mainShadowsTexture.IsValid()) builder.UseTexture(resources.mainShadowsTexture);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc(static (PassData passData, RasterGraphContext context) =>
                                          passData.draw.Draw(context.cmd, passData.view, passData.hasMask,
                                                             passData.overlay, IsUpsideDown(context, passData.picture)));
            }
        }

        // The chain's textures start at the bottom row, like all textures that are not the back buffer.
        private static bool IsUpsideDown(in RasterGraphContext context, in TextureHandle picture)
        {
#if UNITY_6000_5_OR_NEWER
            return context.GetTextureUVOrigin(picture) == TextureUVOrigin.TopLeft;
#else
            return false;
#endif
        }
    }
}
#endif
