using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// The numbers one camera's shadow is computed from. Filled anew for every camera and frame, nothing is allocated.
    /// </summary>
    internal struct ShadowFrame
    {
        internal const int MostViews = 2;

        internal ShadowOptions options;
        internal ShadowUniforms uniforms;

        /// <summary>The camera draws over what another one has drawn.</summary>
        internal bool overlay;

        /// <summary>A face of a reflection probe.</summary>
        internal bool isProbe;

        /// <summary>Of the camera's target in pixels, before dynamic resolution.</summary>
        internal int width;
        internal int height;

        /// <summary>The share of the target that dynamic resolution draws into, 0 to 1.</summary>
        internal float widthScale;
        internal float heightScale;

        /// <summary>(uv, stored camera depth, 1) to world, by eye; both the same unless both are drawn at once.</summary>
        internal Matrix4x4 screenToWorld0;
        internal Matrix4x4 screenToWorld1;

        /// <summary>Drawn at once.</summary>
        internal int views;

        /// <summary>Where two views are drawn at once: the pass of XR that does so.</summary>
        internal XRPass xr;

        /// <summary>Of the shadow map.</summary>
        internal AtlasLayout layout;

        /// <summary>Bits of the cascades that were drawn anew; URP draws all of them for every camera.</summary>
        internal int updatedCascades;

        /// <summary>What the chain keeps of this camera from frame to frame holds nothing yet.</summary>
        internal bool storeIsEmpty;

        /// <summary>No frame was before this one.</summary>
        internal bool historiesAreEmpty;

        internal bool UpdatesAny => storeIsEmpty || updatedCascades != 0;

        internal bool Updates(int cascade) => storeIsEmpty || (updatedCascades >> cascade & 1) != 0;
    }
}
