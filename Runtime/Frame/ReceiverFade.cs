using System;
using System.Reflection;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if UNITY_6000_0_OR_NEWER
using RasterCommands = UnityEngine.Rendering.RasterCommandBuffer;
#else
using RasterCommands = UnityEngine.Rendering.CommandBuffer;
#endif

namespace Penumbra
{
    /// <summary>
    /// URP's receivers fade their shadow out towards the shadow distance: GetMainLightShadowFade is
    /// saturate(d² z + w), with z and w of _MainLightShadowParams. Far shadows must not fade, so both are 0 from the
    /// feature's pass until transparents are drawn, which read URP's shadow map and get URP's values back. URP sets the
    /// vector anew for every camera.
    ///
    /// With Distance Shadowmask that fade leads to the baked shadow (MixRealtimeAndBakedShadows), which would be lost.
    /// So opaque surfaces have the smaller of both meanwhile, as with Shadowmask: a keyword of URP, which disables it
    /// before every camera.
    /// </summary>
    internal static class ReceiverFade
    {
        internal const string MixingName = "LIGHTMAP_SHADOW_MIXING";

        internal static readonly int Uniform = Shader.PropertyToID("_MainLightShadowParams");

        private static GlobalKeyword mixing;
        private static bool created;

        /// <summary>
        /// Stops the fade of opaque surfaces, if this frame draws far shadows. It comes before the chain, which reads
        /// the light's strength: beside an empty map URP leaves the strength out of the vector.
        /// </summary>
        internal static void Stop(CommandBuffer commands, in ShadowFrame frame)
        {
            if (!frame.options.DrawsBeyondCascades) return;
            commands.SetGlobalVector(Uniform, new Vector4(frame.receivers.x, frame.receivers.y, 0.0f, 0.0f));
            if (!frame.fadesToBaked) return;
            if (!created) mixing = GlobalKeyword.Create(MixingName);
            created = true;
            commands.SetKeyword(mixing, true);
        }

        /// <summary>Restores what URP has set.</summary>
        internal static void Restore(RasterCommands commands, in ShadowFrame frame)
        {
            if (!frame.options.DrawsBeyondCascades) return;
            commands.SetGlobalVector(Uniform, frame.urpReceivers);
            if (frame.fadesToBaked) commands.SetKeyword(mixing, false);
        }

        /// <summary>
        /// The vector as URP 14 and 17 set it (MainLightShadowCasterPass.SetupMainLightShadowReceiverConstants): the
        /// light's strength, its soft quality, then scale and bias of the fade.
        /// </summary>
        /// <param name="border">The last border of the cascades, a share of the distance.</param>
        internal static Vector4 OfUrp(Light light, bool supportsSoftShadows, float distanceMetres, float border)
        {
            float squared = distanceMetres * distanceMetres;
            float soft = supportsSoftShadows && light.shadows == LightShadows.Soft ? SoftQuality(light) : 0.0f;
            // This is ShadowUtils.GetScaleAndBiasForLinearDistanceFade.
            if (border < 0.0001f) return new Vector4(light.shadowStrength, soft, 1000.0f, -1000.0f * squared);
            float begin = (1.0f - border) * (1.0f - border) * squared;
            return new Vector4(light.shadowStrength, soft, 1.0f / (squared - begin), -begin / (squared - begin));
        }

        /// <summary>The vector beside an empty map, as URP 14, 17.0 and 17.5 set it.</summary>
        internal static Vector4 OfEmptyMap(Light light, bool supportsSoftShadows, float distanceMetres, float border)
        {
#if UNITY_6000_5_OR_NEWER
            // URP 17.5 passes the distance where its square is expected.
            return OfUrp(light, supportsSoftShadows, Mathf.Sqrt(distanceMetres), border);
#elif UNITY_6000_0_OR_NEWER
            return new Vector4(0.0f, 0.0f, 1.0f, 0.0f);
#else
            return new Vector4(1.0f, 0.0f, 1.0f, 0.0f);
#endif
        }

        // This is ShadowUtils.SoftShadowQualityToShaderProperty.
        private static float SoftQuality(Light light)
        {
            if (!light.TryGetComponent(out UniversalAdditionalLightData data)) return 1.0f;
            SoftShadowQuality quality = data.softShadowQuality;
            if (quality == SoftShadowQuality.UsePipelineSettings) quality = OfAsset();
            return Math.Max((int)quality, (int)SoftShadowQuality.Low);
        }

        // The asset's quality is internal to URP. If a version does not have it under this name, it is taken to be the
        // default of new assets.
        private static readonly Func<UniversalRenderPipelineAsset, SoftShadowQuality> qualityOf = Getter();

        private static SoftShadowQuality OfAsset()
        {
            var asset = GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset;
            return asset != null && qualityOf != null ? qualityOf(asset) : SoftShadowQuality.Medium;
        }

        private static Func<UniversalRenderPipelineAsset, SoftShadowQuality> Getter()
        {
            MethodInfo getter = typeof(UniversalRenderPipelineAsset).GetMethod(
                "get_softShadowQuality", BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
            if (getter == null || getter.ReturnType != typeof(SoftShadowQuality)) return null;
            return (Func<UniversalRenderPipelineAsset, SoftShadowQuality>)getter.CreateDelegate(
                typeof(Func<UniversalRenderPipelineAsset, SoftShadowQuality>));
        }
    }
}
