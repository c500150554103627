using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The pipeline's knowledge of the main light's shadow for one camera, independent of URP's version. Expensive
    /// values are read last and only if everything else allows a shadow: see UrpFrame.
    /// </summary>
    internal struct ShadowSource
    {
        internal CameraType cameraType;

        /// <summary>Whether the camera draws only depth, into a texture.</summary>
        internal bool depthOnly;

        /// <summary>Whether the camera is a scene view with its lighting switched off.</summary>
        internal bool sceneLightingOff;

        /// <summary>Whether URP's receivers do not read the screen-space texture: see UrpFrame.MetaQuest.</summary>
        internal bool metaQuest;

        /// <summary>Number of views drawn at once.</summary>
        internal int views;

        /// <summary>Whether the asset, the quality level and the device allow main light shadows.</summary>
        internal bool supported;

        /// <summary>The index of the main light; -1 without one.</summary>
        internal int mainLightIndex;

        /// <summary>The main light; null without one, or without shadows of it in the asset.</summary>
        internal Light light;

        internal LightShadows lightShadows;

        /// <summary>The direction towards the main light, world space, of length 1.</summary>
        internal Vector3 towardLight;

        /// <summary>URP's _MainLightShadowParams, with a shadow map and with an empty one: see ReceiverFade.</summary>
        internal Vector4 receivers;
        internal Vector4 emptyReceivers;

        /// <summary>Whether receivers fade to the light's baked shadow (Distance Shadowmask).</summary>
        internal bool fadesToBaked;
        internal float distanceMetres;

        /// <summary>Whether something casts a shadow into this camera's cascades.</summary>
        internal bool hasCasters;

        /// <summary>Whether the engine has computed the light's matrices for every cascade.</summary>
        internal bool hasCascades;

        internal int cascadeCount;

        /// <summary>Width of the whole atlas in texels: the asset's shadow resolution.</summary>
        internal int mapWidth;
    }

    /// <summary>The reason why Penumbra skips a camera, which then has URP's own shadows.</summary>
    internal enum SkipReason
    {
        /// <summary>The camera is not skipped.</summary>
        None,
        PreviewCamera,
        DepthOnlyCamera,
        SceneViewOff,
        ReflectionProbesOff,
        SceneLightingOff,
        ShadowsOff,
        NoMainLight,
        LightWithoutShadows,
        NoShadowDistance,
        NoCasters,
        InvalidCascade,
        MissingShader,

        /// <summary>
        /// The shader or another asset of the technique's graph is missing: see PenumbraShadows.MissingPass.
        /// </summary>
        MissingPass,
        CompatibilityMode,
        MetaQuest,
    }

    internal static class FrameGate
    {
        /// <summary>
        /// The reason to skip the camera, by URP's own conditions for main light shadows and the feature's settings for
        /// kinds of cameras. Where there is one, URP's keywords must stay as they are.
        /// </summary>
        internal static SkipReason Reason(in ShadowSource source, PenumbraShadowsSettings settings)
        {
            if (source.cameraType == CameraType.Preview) return SkipReason.PreviewCamera;
            if (source.depthOnly) return SkipReason.DepthOnlyCamera;
            if (source.metaQuest) return SkipReason.MetaQuest;
            if (source.cameraType == CameraType.SceneView && !settings.sceneView) return SkipReason.SceneViewOff;
            if (source.cameraType == CameraType.Reflection && !settings.reflectionProbes)
                return SkipReason.ReflectionProbesOff;
            if (source.sceneLightingOff) return SkipReason.SceneLightingOff;
            if (!source.supported) return SkipReason.ShadowsOff;
            if (source.mainLightIndex < 0) return SkipReason.NoMainLight;
            if (source.lightShadows == LightShadows.None) return SkipReason.LightWithoutShadows;
            return source.distanceMetres > 0.0f ? SkipReason.None : SkipReason.NoShadowDistance;
        }

        /// <summary>
        /// The reason why URP draws no shadow map, but binds an empty one with stale matrices: nothing casts into the
        /// cascades. Only shadows beyond them can be drawn then.
        /// </summary>
        internal static SkipReason WithoutMap(in ShadowSource source)
        {
            if (!source.hasCasters) return SkipReason.NoCasters;
            return source.hasCascades ? SkipReason.None : SkipReason.InvalidCascade;
        }
    }
}
