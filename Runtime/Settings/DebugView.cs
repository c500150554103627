namespace Penumbra
{
    /// <summary>
    /// What is drawn over the camera's image, in the editor and in development builds; each view is a pass of
    /// Shaders/PenumbraDebugViews.shader. Drawn before post-processing, which changes it: disable that for exact
    /// colours.
    /// </summary>
    public enum DebugView
    {
        None,

        /// <summary>The screen-space shadow texture: black 0, white 1.</summary>
        Visibility,

        /// <summary>Sky blue, orange, green, purple from the nearest on; dark grey outside the shadow map.</summary>
        Cascades,

        /// <summary>
        /// The shadow map's texels as a chequerboard: blue up to a pixel wide, vermilion from eight.
        /// </summary>
        ShadowTexels,

        /// <summary>
        /// Width of the penumbra across the light: dark red 1 cm, orange 10 cm, white 1 m and more; blue where it is
        /// narrower than a texel, where a tent filter or a larger shadow map would serve as well.
        /// </summary>
        PenumbraWidth,

        /// <summary>
        /// Yellow where the penumbra mask lets the filter run, grey where it skips it; all yellow without a mask. The
        /// flagship has none: what it decides without its filter is not shown.
        /// </summary>
        PenumbraMask,
    }
}
