using Unity.Collections;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if UNITY_6000_0_OR_NEWER
using FrameCamera = UnityEngine.Rendering.Universal.UniversalCameraData;
#else
using FrameCamera = UnityEngine.Rendering.Universal.CameraData;
#endif

namespace Penumbra
{
    /// <summary>Converts URP's frame data to Penumbra's.</summary>
    internal static class UrpFrame
    {
        /// <summary>
        /// Whether this is the build profile Meta Quest. With it, URP 17.5's MainLightRealtimeShadow
        /// (ShaderLibrary/Shadows.hlsl) returns 1 where the shadow coordinate is outside 0 to 1, before it reads the
        /// screen-space texture. Forward receivers pass the screen-space coordinate before its division by w, so almost
        /// all of them would be lit. URP 17.3 has no such check. 17.4 has not been examined and is treated like 17.5.
        /// </summary>
#if UNITY_META_QUEST && UNITY_6000_4_OR_NEWER
        internal const bool MetaQuest = true;
#else
        internal const bool MetaQuest = false;
#endif

        internal static ShadowSource Source(ref RenderingData data)
        {
            ShadowSource source = default;
            source.cameraType = data.cameraData.cameraType;
            RenderTexture texture = data.cameraData.targetTexture;
            source.depthOnly = texture != null && texture.format == RenderTextureFormat.Depth;
            source.metaQuest = MetaQuest;
            source.views = Views(data.cameraData.xr);
            source.supported = data.shadowData.supportsMainLightShadows;
            source.mainLightIndex = data.lightData.mainLightIndex;
            source.distanceMetres = data.cameraData.maxShadowDistance;
            source.cascadeCount = data.shadowData.mainLightShadowCascadesCount;
            source.mapWidth = data.shadowData.mainLightShadowmapWidth;
#if UNITY_EDITOR
            source.sceneLightingOff = CoreUtils.IsSceneLightingDisabled(data.cameraData.camera);
#endif
            ReadLight(ref data, ref source);
            return source;
        }

        // URP computes the bounds on request, so this comes last and only if there is a light.
        private static void ReadLight(ref RenderingData data, ref ShadowSource source)
        {
            NativeArray<VisibleLight> lights = data.lightData.visibleLights;
            if (!source.supported || source.mainLightIndex < 0 || source.mainLightIndex >= lights.Length) return;
            Light light = lights[source.mainLightIndex].light;
            source.light = light;
            source.lightShadows = light != null ? light.shadows : LightShadows.None;
            if (source.lightShadows == LightShadows.None) return;
            Vector3 forward = light.transform.forward;
            source.towardLight = new Vector3(-forward.x, -forward.y, -forward.z);
            source.receivers = ReceiverFade.OfUrp(light, data.shadowData.supportsSoftShadows, source.distanceMetres,
                                                  data.shadowData.mainLightShadowCascadeBorder);
            source.emptyReceivers = ReceiverFade.OfEmptyMap(light, data.shadowData.supportsSoftShadows, source.distanceMetres,
                                                            data.shadowData.mainLightShadowCascadeBorder);
            LightBakingOutput baked = light.bakingOutput;
            source.fadesToBaked = data.lightData.supportsMixedLighting &&
                                  baked.lightmapBakeType == LightmapBakeType.Mixed &&
                                  baked.mixedLightingMode == MixedLightingMode.Shadowmask &&
                                  QualitySettings.shadowmaskMode == ShadowmaskMode.DistanceShadowmask;
            source.hasCasters = data.cullResults.GetShadowCasterBounds(source.mainLightIndex, out Bounds _);
            source.hasCascades = source.hasCasters && HasCascades(ref data, source, light.shadowNearPlane);
        }

        // URP asks the engine for the same matrices. If a cascade has none, URP binds an empty map instead.
        private static bool HasCascades(ref RenderingData data, in ShadowSource source, float nearPlane)
        {
            int resolution = new AtlasLayout(source.mapWidth, source.cascadeCount).TileResolution;
            for (int cascade = 0; cascade < source.cascadeCount; ++cascade)
                if (!data.cullResults.ComputeDirectionalShadowMatricesAndCullingPrimitives(
                        source.mainLightIndex, cascade, source.cascadeCount,
                        data.shadowData.mainLightShadowCascadesSplit, resolution, nearPlane, out Matrix4x4 _,
                        out Matrix4x4 _, out ShadowSplitData _)) return false;
            return true;
        }

        /// <summary>
        /// The part of the frame that is known when URP asks the feature for its passes; TrySetCamera adds the rest.
        /// </summary>
        internal static ShadowFrame Frame(in ShadowSource source, in ShadowOptions options, NoiseMode noise)
        {
            ShadowFrame frame = default;
            frame.options = options;
            frame.receivers = source.receivers;
            frame.overLit = FrameGate.WithoutMap(source) != SkipReason.None;
            frame.urpReceivers = frame.overLit ? source.emptyReceivers : source.receivers;
            frame.fadesToBaked = source.fadesToBaked;
            frame.isProbe = source.cameraType == CameraType.Reflection;
            frame.views = source.views;
            frame.layout = new AtlasLayout(source.mapWidth, source.cascadeCount);
            frame.updatedCascades = (1 << frame.layout.Cascades) - 1;
            frame.uniforms = new ShadowUniforms(options.Parameters(), frame.layout,
                                                noise == NoiseMode.PerFrame || options.Accumulates ? Time.frameCount : 0);
            return frame;
        }

        /// <summary>
        /// Sets the target's size, the part of it that dynamic resolution uses, and each eye's matrix; false if the
        /// camera can draw no image.
        /// </summary>
        internal static bool TrySetCamera(ref ShadowFrame frame, ref FrameCamera camera)
        {
            SetSize(ref frame, camera.cameraTargetDescriptor);
            frame.views = Views(camera.xr);
            frame.xr = camera.xr;
            frame.overlay = camera.renderType == CameraRenderType.Overlay;
            if (!TryGetScreenToWorld(camera.GetViewMatrix(0), camera.GetProjectionMatrix(0),
                                     out frame.screenToWorld0)) return false;
            frame.screenToWorld1 = frame.screenToWorld0;
            return frame.views == 1 ||
                   TryGetScreenToWorld(camera.GetViewMatrix(1), camera.GetProjectionMatrix(1),
                                       out frame.screenToWorld1);
        }

        private static int Views(XRPass xr) => xr.enabled && xr.singlePassEnabled ? 2 : 1;

        internal static void SetSize(ref ShadowFrame frame, in RenderTextureDescriptor target)
        {
            frame.width = target.width;
            frame.height = target.height;
            frame.widthScale = target.useDynamicScale ? ScalableBufferManager.widthScaleFactor : 1.0f;
            frame.heightScale = target.useDynamicScale ? ScalableBufferManager.heightScaleFactor : 1.0f;
        }

        // Camera depth is always drawn into a texture, whatever the camera's target, so this is the projection for
        // textures.
        private static bool TryGetScreenToWorld(Matrix4x4 view, Matrix4x4 projection, out Matrix4x4 screenToWorld) =>
            ScreenToWorld.TryGet(view, GL.GetGPUProjectionMatrix(projection, true),
                                 new ScreenConventions(SystemInfo.graphicsUVStartsAtTop,
                                                       SystemInfo.usesReversedZBuffer), out screenToWorld);

#if !UNITY_6000_0_OR_NEWER
        /// <summary>
        /// Whether this camera draws a G-buffer. URP 14 has no public property for that, but only deferred renderers do
        /// not support multisampling. Overlay cameras and wireframe use forward rendering even in a deferred renderer.
        /// </summary>
        internal static bool IsDeferred(ScriptableRenderer renderer, in CameraData camera) =>
            !renderer.supportedRenderingFeatures.msaa && camera.renderType == CameraRenderType.Base && !GL.wireframe;
#endif

        /// <summary>
        /// Whether this is Unity 6 with the render graph disabled, which some versions still allow: the feature draws
        /// nothing then.
        /// </summary>
        internal static bool InCompatibilityMode()
        {
#if PENUMBRA_COMPATIBILITY_MODE
            RenderGraphSettings graph = GraphicsSettings.GetRenderPipelineSettings<RenderGraphSettings>();
            return graph != null && graph.enableRenderCompatibilityMode;
#else
            return false;
#endif
        }

        /// <summary>
        /// The descriptor of a chain's texture; textures of the screen have the camera's layout of eyes.
        /// </summary>
        internal static RenderTextureDescriptor Texture(RenderTextureDescriptor target, in ChainTexture texture,
                                                        in ShadowFrame frame)
        {
            TextureSize size = TextureSize.Of(texture, frame);
            target.width = size.width;
            target.height = size.height;
            if (texture.extent != GraphExtent.Screen || texture.layers > 1) SetSlices(ref target, texture, size.depth);
            // The copy of a mip level has the level's size without dynamic resolution, which contains the scaled part.
            if (texture.extent != GraphExtent.Screen || texture.level > 0) target.useDynamicScale = false;
            target.msaaSamples = texture.samples;
            target.bindMS = texture.samples > 1;
            target.useMipMap = texture.mips != 1;
            target.autoGenerateMips = false;
            target.enableRandomWrite = texture.randomWrite;
            target.depthStencilFormat = texture.isDepth ? texture.format : GraphicsFormat.None;
            target.graphicsFormat = texture.isDepth ? GraphicsFormat.None : DeviceFormats.Of(texture);
            return target;
        }

        // Both eyes share these slices.
        private static void SetSlices(ref RenderTextureDescriptor target, in ChainTexture texture, int slices)
        {
            target.volumeDepth = slices;
            target.dimension = texture.depth > 1 ? TextureDimension.Tex3D
                               : texture.layers > 1 || texture.extent == GraphExtent.Tile ? TextureDimension.Tex2DArray
                                                                                         : TextureDimension.Tex2D;
            target.vrUsage = VRTextureUsage.None;
        }
    }
}
