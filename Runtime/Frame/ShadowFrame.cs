using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// The data from which one camera's shadow is computed. They are set for every camera and frame without allocating.
    /// </summary>
    internal struct ShadowFrame
    {
        internal const int MostViews = 2;

        internal ShadowOptions options;
        internal ShadowUniforms uniforms;
        internal FarFrame far;

        /// <summary>
        /// This camera's _MainLightShadowParams: what the light has, and what URP has set. See ReceiverFade.
        /// </summary>
        internal Vector4 receivers;
        internal Vector4 urpReceivers;

        /// <summary>Whether receivers fade to the light's baked shadow (Distance Shadowmask).</summary>
        internal bool fadesToBaked;

        /// <summary>Whether URP has an empty shadow map: see FrameGate.WithoutMap.</summary>
        internal bool overLit;

        /// <summary>Whether this is an overlay camera, which draws over the image of another camera.</summary>
        internal bool overlay;

        /// <summary>Whether the camera draws a face of a reflection probe.</summary>
        internal bool isProbe;

        /// <summary>Size of the camera's target in pixels, before dynamic resolution.</summary>
        internal int width;
        internal int height;

        /// <summary>The fraction of the target's width that dynamic resolution uses, 0 to 1.</summary>
        internal float widthScale;
        internal float heightScale;

        /// <summary>
        /// The matrix from (uv, stored camera depth, 1) to world, per eye; both are equal unless both eyes are drawn at
        /// once.
        /// </summary>
        internal Matrix4x4 screenToWorld0;
        internal Matrix4x4 screenToWorld1;

        /// <summary>
        /// The matrix from (uv, stored camera depth, 1) to the same of the camera's frame before, per eye; the identity
        /// without one.
        /// </summary>
        internal Matrix4x4 toPreviousScreen0;
        internal Matrix4x4 toPreviousScreen1;

        /// <summary>Number of views drawn at once: 2 with single-pass XR, otherwise 1.</summary>
        internal int views;

        /// <summary>The XR pass that draws both views, if there are two.</summary>
        internal XRPass xr;

        /// <summary>Layout of the shadow map.</summary>
        internal AtlasLayout layout;

        /// <summary>Bit mask of the cascades that were redrawn; URP redraws all of them for every camera.</summary>
        internal int updatedCascades;

        /// <summary>
        /// Whether the textures that the chain keeps for this camera between frames have no content yet.
        /// </summary>
        internal bool storeIsEmpty;

        /// <summary>
        /// Whether there is no previous frame, so that textures of the previous frame have no content.
        /// </summary>
        internal bool historiesAreEmpty;

        internal bool UpdatesAny => storeIsEmpty || updatedCascades != 0;

        internal bool Updates(int cascade) => storeIsEmpty || (updatedCascades >> cascade & 1) != 0;
    }
}
