#if !UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>Draws a debug view over the camera's image, in URP 14.</summary>
    internal sealed class ClassicDebugPass : ScriptableRenderPass
    {
        private readonly ClassicShadowPass shadows;
        private DebugViewDraw draw;

        internal ClassicDebugPass(ClassicShadowPass shadows)
        {
            this.shadows = shadows;
            renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing;
            profilingSampler = new ProfilingSampler("Penumbra Debug View");
            // This makes the camera render to a texture instead of the back buffer, whose rows run in the opposite
            // direction on some devices.
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
