#if !UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// URP 14: gives transparents, which the screen-space texture does not know, URP's own shadow map back.
    /// </summary>
    internal sealed class ClassicRestorePass : ScriptableRenderPass
    {
        internal ClassicRestorePass()
        {
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
            profilingSampler = new ProfilingSampler("Penumbra Shadows Restore");
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer commands = CommandBufferPool.Get();
            using (new ProfilingScope(commands, profilingSampler))
                ShadowKeywords.Global.Restore(commands, renderingData.shadowData.mainLightShadowCascadesCount);
            context.ExecuteCommandBuffer(commands);
            CommandBufferPool.Release(commands);
        }
    }
}
#endif
