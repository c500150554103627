#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Unity 6: gives transparents, which the screen-space texture does not know, URP's own shadow map back.
    /// </summary>
    internal sealed class GraphRestorePass : ScriptableRenderPass
    {
        private sealed class PassData
        {
            internal int cascadeCount;
        }

        internal GraphRestorePass()
        {
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
            profilingSampler = new ProfilingSampler("Penumbra Shadows Restore");
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            using (IUnsafeRenderGraphBuilder builder =
                       renderGraph.AddUnsafePass("Penumbra Shadows Restore", out PassData data, profilingSampler))
            {
                data.cascadeCount = frameData.Get<UniversalShadowData>().mainLightShadowCascadesCount;
                builder.AllowPassCulling(false);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc(static (PassData passData, UnsafeGraphContext context) =>
                    ShadowKeywords.Global.Restore(CommandBufferHelpers.GetNativeCommandBuffer(context.cmd),
                                                  passData.cascadeCount));
            }
        }
    }
}
#endif
