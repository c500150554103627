using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// What the pipeline knows of the main light's shadow for one camera, independent of URP's version. Expensive
    /// values are read last and only if everything else allows a shadow: see UrpFrame.
    /// </summary>
    internal struct ShadowSource
    {
        internal CameraType cameraType;

        /// <summary>The camera draws only depth, into a texture.</summary>
        internal bool depthOnly;

        /// <summary>Scene view with its lighting switched off.</summary>
        internal bool sceneLightingOff;

        /// <summary>URP's receivers do not read the screen-space texture: see UrpFrame.MetaQuest.</summary>
        internal bool metaQuest;

        /// <summary>Number of views drawn at once.</summary>
        internal int views;

        /// <summary>The asset, the quality level and the device allow main light shadows.</summary>
        internal bool supported;

        /// <summary>-1 without a main light.</summary>
        internal int mainLightIndex;

        /// <summary>The main light; null without one, or without shadows of it in the asset.</summary>
        internal Light light;

        internal LightShadows lightShadows;

        /// <summary>Towards the main light, world space, of length 1.</summary>
        internal Vector3 towardLight;

        /// <summary>URP's _MainLightShadowParams, with a shadow map and with an empty one: see ReceiverFade.</summary>
        internal Vector4 receivers;
        internal Vector4 emptyReceivers;

        /// <summary>Distance Shadowmask: receivers fade to the light's baked shadow.</summary>
        internal bool fadesToBaked;
        internal float distanceMetres;

        /// <summary>Something casts a shadow into this camera's cascades.</summary>
        internal bool hasCasters;

        /// <summary>The engine has computed the light's matrices for every cascade.</summary>
        internal bool hasCascades;

        internal int cascadeCount;

        /// <summary>Width of the whole atlas in texels: the asset's shadow resolution.</summary>
        internal int mapWidth;
    }

    /// <summary>Why Penumbra skips a camera, which then has URP's own shadows.</summary>
    internal enum SkipReason
    {
        /// <summary>Not skipped.</summary>
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

        /// <summary>The shader or another asset of the technique's graph: see PenumbraShadows.MissingPass.</summary>
        MissingPass,
        CompatibilityMode,
        MetaQuest,
    }

    internal static class FrameGate
    {
        /// <summary>
        /// URP's own conditions for main light shadows, and the feature's settings for kinds of cameras. In any other case
        /// URP's keywords must stay as they are.
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
        /// Why URP draws no shadow map, but binds an empty one with stale matrices: nothing casts into the cascades. Only
        /// what lies beyond them can be drawn then.
        /// </summary>
        internal static SkipReason WithoutMap(in ShadowSource source)
        {
            if (!source.hasCasters) return SkipReason.NoCasters;
            return source.hasCascades ? SkipReason.None : SkipReason.InvalidCascade;
        }
    }
}
