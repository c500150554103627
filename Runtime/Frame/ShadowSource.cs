using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// What the pipeline says of the main light's shadow for one camera, in words that are the same for every URP. What
    /// is read only when all else speaks for a shadow is asked for last: see UrpFrame.
    /// </summary>
    internal struct ShadowSource
    {
        internal CameraType cameraType;

        /// <summary>The camera draws nothing but depth, into a texture.</summary>
        internal bool depthOnly;

        /// <summary>Scene view with its light bulb off.</summary>
        internal bool sceneLightingOff;

        /// <summary>URP's receivers do not get to the screen-space texture: see UrpFrame.MetaQuest.</summary>
        internal bool metaQuest;

        /// <summary>Drawn at once.</summary>
        internal int views;

        /// <summary>The asset, the quality level and the device allow main light shadows.</summary>
        internal bool supported;

        /// <summary>-1 without a main light.</summary>
        internal int mainLightIndex;

        internal LightShadows lightShadows;
        internal float distanceMetres;

        /// <summary>Something casts a shadow into this camera's cascades.</summary>
        internal bool hasCasters;

        /// <summary>The engine has found a view of the light for every cascade.</summary>
        internal bool hasCascades;

        internal int cascadeCount;

        /// <summary>Of the whole atlas, in texels: the asset's shadow resolution.</summary>
        internal int mapWidth;
    }

    /// <summary>Why a frame is left to URP.</summary>
    internal enum SkipReason
    {
        /// <summary>Nothing stands against it.</summary>
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

        /// <summary>Of the shader or another asset of the technique's graph: see PenumbraShadows.MissingPass.</summary>
        MissingPass,
        CompatibilityMode,
        UnsupportedDevice,
        MetaQuest,
    }

    internal static class FrameGate
    {
        /// <summary>
        /// URP's own conditions for drawing a main light shadow map, and the settings' for whom to draw it. In every
        /// other case URP binds an empty map and stale matrices, and its keywords must stay as they are.
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

        /// <summary>
        /// PCSS's programs ask for shader target 4.5 (`SystemInfo.graphicsShaderLevel`); a device below it has none of
        /// them.
        /// </summary>
        internal static bool Runs(in ShadowOptions options, int shaderLevel) =>
            !options.technique.TakesSamples() || shaderLevel >= 45;
    }
}
