using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if UNITY_6000_0_OR_NEWER
using FrameShadows = UnityEngine.Rendering.Universal.UniversalShadowData;
#else
using FrameShadows = UnityEngine.Rendering.Universal.ShadowData;
#endif

namespace Penumbra
{
    /// <summary>
    /// Finds the casters of each cascade and makes renderer lists of them for a program. URP's own lists of casters
    /// draw the materials' ShadowCaster passes and take no other program, and the camera's culling results lack
    /// casters outside its frustum. So each cascade is culled once more, as an orthographic camera of the light.
    /// </summary>
    internal static class CasterCulling
    {
        // Materials with a ShadowCaster pass cast shadows; those with a DepthOnly pass are in the camera's depth.
        private static readonly ShaderTagId casters = new ShaderTagId("ShadowCaster");
        private static readonly ShaderTagId opaques = new ShaderTagId("DepthOnly");

        // Transparent materials have neither pass; these are the passes that URP draws them with.
        private static readonly ShaderTagId[] blended =
        {
            new ShaderTagId("UniversalForward"), new ShaderTagId("UniversalForwardOnly"),
            new ShaderTagId("SRPDefaultUnlit"),
        };

        /// <summary>Culls the casters; `frame.camera`, `seen` and `light` must be set.</summary>
        internal static void Cull(ScriptableRenderContext context, CasterFrame frame, int lightIndex,
                                  FrameShadows shadows, in ShadowFrame shadow)
        {
            int resolution = shadow.layout.TileResolution;
            for (int cascade = 0; cascade < CasterFrame.MostCascades; ++cascade)
            {
                ref CasterView view = ref frame.cascades[cascade];
                view.isCulled = cascade < shadow.layout.Cascades && shadow.Updates(cascade) &&
                    frame.seen.ComputeDirectionalShadowMatricesAndCullingPrimitives(
                        lightIndex, cascade, shadow.layout.Cascades, shadows.mainLightShadowCascadesSplit, resolution,
                        frame.light.light.shadowNearPlane, out view.view, out view.projection,
                        out ShadowSplitData split) &&
                    TryCull(context, frame.camera, split, ref view);
                if (!view.isCulled) continue;
#if UNITY_6000_0_OR_NEWER
                view.bias = ShadowUtils.GetShadowBias(ref frame.light, lightIndex, shadows, view.projection, resolution);
#else
                view.bias =
                    ShadowUtils.GetShadowBias(ref frame.light, lightIndex, ref shadows, view.projection, resolution);
#endif
            }
        }

        private static bool TryCull(ScriptableRenderContext context, Camera camera, in ShadowSplitData split,
                                    ref CasterView view)
        {
            if (!camera.TryGetCullingParameters(out ScriptableCullingParameters parameters)) return false;
            // The casters keep the camera's layers and levels of detail. There is no occlusion culling, which would be
            // from the camera's view, and there are no lights, which are not needed.
            parameters.cullingOptions = CullingOptions.ForceEvenIfCameraIsNotActive;
            parameters.isOrthographic = true;
            parameters.cullingMatrix = view.projection * view.view;
            parameters.cullingPlaneCount = split.cullingPlaneCount;
            for (int plane = 0; plane < split.cullingPlaneCount; ++plane)
                parameters.SetCullingPlane(plane, split.GetCullingPlane(plane));
            view.casters = context.Cull(ref parameters);
            return true;
        }

        /// <summary>
        /// The list that a step draws for a cascade, or in place of the first cascade's what the camera sees. False if
        /// there is none.
        /// </summary>
        internal static bool TryList(CasterFrame frame, ChainStep step, int cascade, in PassProgram program,
                                     out RendererListParams list)
        {
            list = default;
            if (step.pass.kind != PassKind.Casters) return false;
            if (step.ByCascade ? !frame.cascades[cascade].isCulled : cascade > 0) return false;
            CullingResults results = step.ByCascade ? frame.cascades[cascade].casters : frame.seen;
            list = step.pass.blended ? Blended(results, frame.camera, program)
                   : step.ByCascade ? List(results, frame.camera, casters, RenderQueueRange.all, program)
                                    : List(results, frame.camera, opaques, RenderQueueRange.opaque, program);
            return true;
        }

        private static RendererListParams Blended(in CullingResults results, Camera camera, in PassProgram program)
        {
            DrawingSettings drawing = Drawing(camera, blended[0], SortingCriteria.CommonTransparent, program);
            for (int tag = 1; tag < blended.Length; ++tag) drawing.SetShaderPassName(tag, blended[tag]);
            return new RendererListParams(results, drawing, new FilteringSettings(RenderQueueRange.transparent));
        }

        private static RendererListParams List(in CullingResults results, Camera camera, ShaderTagId tag,
                                               RenderQueueRange queues, in PassProgram program) =>
            new RendererListParams(results, Drawing(camera, tag, SortingCriteria.CommonOpaque, program),
                                   new FilteringSettings(queues));

        // The shader is overridden and not the material, to keep each object's properties for alpha clipping and
        // displacement.
        private static DrawingSettings Drawing(Camera camera, ShaderTagId tag, SortingCriteria sorting,
                                               in PassProgram program) =>
            new DrawingSettings(tag, new SortingSettings(camera) { criteria = sorting })
            {
                overrideShader = program.asset.material.shader, overrideShaderPassIndex = program.index,
            };
    }
}
