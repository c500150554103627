using UnityEngine;
using UnityEngine.Rendering;
#if UNITY_6000_0_OR_NEWER
using Unity.Collections;
#endif

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>Draws the sun's cascades into an atlas, and sets the uniforms of Shaders/SunShadow.hlsl.</summary>
    internal sealed class SunShadowMap
    {
        private const int DepthBits = 32;

        private static readonly int map = Shader.PropertyToID("_SunShadowMap");

        private readonly SunShadowSettings settings;
        private readonly SunUniforms uniforms = new SunUniforms();
        private readonly SunCascade[] cascades = new SunCascade[AtlasLayout.MostCascades];

        internal SunShadowMap(SunShadowSettings settings) { this.settings = settings; }

        /// <summary>Draws the map and leaves it bound. Without a sun or casters, the map has one texel.</summary>
        internal void Draw(ScriptableRenderContext context, CommandBuffer commands, CullingResults visible, int sun)
        {
            AtlasLayout layout = settings.Layout;
            bool drawn = sun != Sun.None && visible.GetShadowCasterBounds(sun, out Bounds _);
            int width = drawn ? layout.Width : 1;
            int height = drawn ? layout.Height : 1;
            commands.GetTemporaryRT(map, width, height, DepthBits, FilterMode.Bilinear, RenderTextureFormat.Shadowmap);
            commands.SetRenderTarget(map, RenderBufferLoadAction.DontCare, RenderBufferStoreAction.Store);
            commands.ClearRenderTarget(true, false, Color.clear);
            if (drawn)
            {
                Compute(visible, sun, layout);
                DrawCascades(context, commands, visible, sun, layout.Cascades);
            }
            uniforms.Set(commands, settings, layout, cascades, drawn ? layout.Cascades : 0);
            context.ExecuteCommandBuffer(commands);
            commands.Clear();
        }

        internal void Release(CommandBuffer commands) { commands.ReleaseTemporaryRT(map); }

        private void Compute(CullingResults visible, int sun, in AtlasLayout layout)
        {
            float nearPlane = visible.visibleLights[sun].light.shadowNearPlane;
            for (int i = 0; i < layout.Cascades; ++i)
            {
                SunCascade cascade = default;
                bool any = visible.ComputeDirectionalShadowMatricesAndCullingPrimitives(
                    sun, i, layout.Cascades, settings.splits, layout.TileResolution, nearPlane, out cascade.view,
                    out cascade.projection, out cascade.split);
                // Casters are drawn into every cascade that they may cast a shadow into.
                cascade.split.shadowCascadeBlendCullingFactor = 1.0f;
                // Zero matrices map nothing: the cascade's sphere is then empty.
                if (!any) cascade = default;
                cascade.Place(i, layout, settings.angularDiameterDegrees, SystemInfo.usesReversedZBuffer);
                cascades[i] = cascade;
            }
        }

        private void DrawCascades(ScriptableRenderContext context, CommandBuffer commands, CullingResults visible,
                                  int sun, int count)
        {
#if UNITY_6000_0_OR_NEWER
            Cull(context, visible, sun, count);
#endif
            for (int i = 0; i < count; ++i)
            {
                if (!cascades[i].scales.IsMapped) continue;
                commands.SetViewport(cascades[i].viewport);
                commands.SetViewProjectionMatrices(cascades[i].view, cascades[i].projection);
                uniforms.SetCasterBias(commands, settings, cascades[i].scales);
                ShadowDrawingSettings drawing = Drawing(visible, sun, i);
                commands.DrawRendererList(context.CreateShadowRendererList(ref drawing));
            }
        }

#if UNITY_6000_0_OR_NEWER
        // Casters are culled for all cascades of all lights at once, before the first cascade is drawn.
        private void Cull(ScriptableRenderContext context, CullingResults visible, int sun, int count)
        {
            var splits = new NativeArray<ShadowSplitData>(count, Allocator.Temp);
            for (int i = 0; i < count; ++i) splits[i] = cascades[i].split;
            var lights = new NativeArray<LightShadowCasterCullingInfo>(visible.visibleLights.Length, Allocator.Temp);
            lights[sun] = new LightShadowCasterCullingInfo
            {
                splitRange = new RangeInt(0, count),
                projectionType = BatchCullingProjectionType.Orthographic,
            };
            context.CullShadowCasters(visible,
                                      new ShadowCastersCullingInfos { splitBuffer = splits, perLightInfos = lights });
        }

        private static ShadowDrawingSettings Drawing(CullingResults visible, int sun, int cascade) =>
            new ShadowDrawingSettings(visible, sun) { splitIndex = cascade };
#else
        private ShadowDrawingSettings Drawing(CullingResults visible, int sun, int cascade) =>
            new ShadowDrawingSettings(visible, sun, BatchCullingProjectionType.Orthographic)
            {
                splitData = cascades[cascade].split,
            };
#endif
    }
}
