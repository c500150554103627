using UnityEngine;

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

        /// <summary>Of the camera's target in pixels, before dynamic resolution.</summary>
        internal int width;
        internal int height;

        /// <summary>The share of the target that dynamic resolution draws into, 0 to 1.</summary>
        internal float widthScale;
        internal float heightScale;

        /// <summary>(uv, stored camera depth, 1) to world, by eye; both the same unless both are drawn at once.</summary>
        internal Matrix4x4 screenToWorld0;
        internal Matrix4x4 screenToWorld1;

        /// <summary>Of the shadow map, all cascades, in texels.</summary>
        internal int MapWidth => (int)uniforms.MainLightAtlasTexelSize.z;
        internal int MapHeight => (int)uniforms.MainLightAtlasTexelSize.w;
    }
}
