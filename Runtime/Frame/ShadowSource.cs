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

        /// <summary>URP's _MainLightShadowParams: see ReceiverFade.</summary>
        internal Vector4 receivers;
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
        UnsupportedDevice,
        MetaQuest,
    }

    internal static class FrameGate
    {
        /// <summary>
        /// URP's own conditions for drawing a main light shadow map, and the feature's settings for kinds of cameras.
        /// In any other case URP binds an empty map and stale matrices, and its keywords must stay as they are.
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
            if (!(source.distanceMetres > 0.0f)) return SkipReason.NoShadowDistance;
            if (!source.hasCasters) return SkipReason.NoCasters;
            return source.hasCascades ? SkipReason.None : SkipReason.InvalidCascade;
        }

        /// <summary>Shader target 4.5, of SystemInfo.graphicsShaderLevel.</summary>
        internal const int Level45 = 45;

        /// <summary>
        /// A device below that level has no program for some filters. Techniques with passes of their own have a
        /// substitute (ChainSubstitute), which may need the level, too.
        /// </summary>
        internal static bool Runs(in ShadowOptions options, int shaderLevel) =>
            !options.technique.NeedsTarget45() || shaderLevel >= Level45 ||
            options.HasPasses && !TechniqueTable.Fallbacks[(int)options.technique].NeedsTarget45();
    }
}
