#if !UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>URP 14: draws a debug view over the camera's image.</summary>
    internal sealed class ClassicDebugPass : ScriptableRenderPass
    {
        private readonly ClassicShadowPass shadows;
        private DebugViewDraw draw;

        internal ClassicDebugPass(ClassicShadowPass shadows)
        {
            this.shadows = shadows;
            renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing;
            profilingSampler = new ProfilingSampler("Penumbra Debug View");
            // Renders to a texture instead of the back buffer, whose rows run in the opposite direction on some
            // devices.
            ConfigureInput(ScriptableRenderPassInput.Color);
        }

        internal void Setup(DebugViewDraw draw) { this.draw = draw; }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (!shadows.HasDrawn) return;
            CommandBuffer commands = CommandBufferPool.Get();
            using (new ProfilingScope(commands, profilingSampler))
                draw.Draw(commands, shadows.Options.debugView, shadows.HasMask, shadows.IsOverlay, upsideDown: false);
            context.ExecuteCommandBuffer(commands);
            CommandBufferPool.Release(commands);
        }
    }
}
#endif
