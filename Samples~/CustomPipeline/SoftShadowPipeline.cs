using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// A minimal pipeline with soft shadows: the sun's cascades, opaque objects, the sky. It draws shaders with a
    /// pass of the light mode PenumbraSampleLit, and uses the first directional light that casts shadows.
    /// </summary>
    public sealed class SoftShadowPipeline : RenderPipeline
    {
        private static readonly ShaderTagId litPass = new ShaderTagId("PenumbraSampleLit");

        private readonly SunShadowSettings settings;
        private readonly SunShadowMap shadowMap;
        private readonly CommandBuffer commands = new CommandBuffer();

        internal SoftShadowPipeline(SunShadowSettings settings)
        {
            this.settings = settings;
            shadowMap = new SunShadowMap(settings);
            commands.name = "Penumbra Sample Pipeline";
            GraphicsSettings.useScriptableRenderPipelineBatching = true;
            GraphicsSettings.lightsUseLinearIntensity = true;
        }

#if !UNITY_6000_1_OR_NEWER  // the overload is abstract until then and obsolete since
        /// <inheritdoc/>
        protected override void Render(ScriptableRenderContext context, Camera[] cameras) =>
            Render(context, new List<Camera>(cameras));
#endif

        /// <inheritdoc/>
        protected override void Render(ScriptableRenderContext context, List<Camera> cameras)
        {
            foreach (Camera camera in cameras)
            {
                BeginCameraRendering(context, camera);
                DrawCamera(context, camera);
                EndCameraRendering(context, camera);
            }
        }

        private void DrawCamera(ScriptableRenderContext context, Camera camera)
        {
#if UNITY_EDITOR
            if (camera.cameraType == CameraType.SceneView)
                ScriptableRenderContext.EmitWorldGeometryForSceneView(camera);
#endif
            if (!camera.TryGetCullingParameters(out ScriptableCullingParameters culling)) return;
            culling.shadowDistance = Mathf.Min(settings.distanceMetres, camera.farClipPlane);
            CullingResults visible = context.Cull(ref culling);

            int sun = Sun.Index(visible.visibleLights);
            Sun.SetUniforms(commands, visible.visibleLights, sun, settings.ambient);
            shadowMap.Draw(context, commands, visible, sun);

            // This comes after the shadow map, which sets its own matrices and target.
            context.SetupCameraProperties(camera);
            DrawSurfaces(context, camera, visible);
            shadowMap.Release(commands);
            Execute(context);
            context.Submit();
        }

        private void DrawSurfaces(ScriptableRenderContext context, Camera camera, CullingResults visible)
        {
            CameraClearFlags clear = camera.clearFlags;
            commands.ClearRenderTarget(clear <= CameraClearFlags.Depth, clear == CameraClearFlags.Color,
                                       Sun.Linear(camera.backgroundColor));
            var sorting = new SortingSettings(camera) { criteria = SortingCriteria.CommonOpaque };
            var opaque = new RendererListParams(visible, new DrawingSettings(litPass, sorting),
                                                new FilteringSettings(RenderQueueRange.opaque));
            commands.DrawRendererList(context.CreateRendererList(ref opaque));
            if (clear == CameraClearFlags.Skybox) commands.DrawRendererList(context.CreateSkyboxRendererList(camera));
        }

        private void Execute(ScriptableRenderContext context)
        {
            context.ExecuteCommandBuffer(commands);
            commands.Clear();
        }

        /// <inheritdoc/>
        protected override void Dispose(bool disposing)
        {
            base.Dispose(disposing);
            commands.Dispose();
        }
    }
}
