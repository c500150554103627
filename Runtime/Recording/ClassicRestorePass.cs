#if !UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// Switches transparents back to URP's own shadow map, in URP 14, as the screen-space texture does not contain
    /// them.
    /// </summary>
    internal sealed class ClassicRestorePass : ScriptableRenderPass
    {
        private readonly ClassicShadowPass shadows;

        internal ClassicRestorePass(ClassicShadowPass shadows)
        {
            this.shadows = shadows;
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
            profilingSampler = new ProfilingSampler("Penumbra Shadows Restore");
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer commands = CommandBufferPool.Get();
            using (new ProfilingScope(commands, profilingSampler))
            {
                int cascadeCount = shadows.Frame.overLit ? 1 : renderingData.shadowData.mainLightShadowCascadesCount;
                ShadowKeywords.Global.Restore(commands, cascadeCount);
                if (shadows.HasDrawn) ReceiverFade.Restore(commands, shadows.Frame);
            }
            context.ExecuteCommandBuffer(commands);
            CommandBufferPool.Release(commands);
        }
    }
}
#endif
