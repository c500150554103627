namespace Penumbra
{
    /// <summary>
    /// The view that is drawn over the camera's image, in the editor and in development builds; each view is a pass of
    /// Shaders/PenumbraDebugViews.shader. It is drawn before post-processing, which changes it: disable that for exact
    /// colours.
    /// </summary>
    public enum DebugView
    {
        None,

        /// <summary>The screen-space shadow texture, from black for 0 to white for 1.</summary>
        Visibility,

        /// <summary>
        /// The cascades in sky blue, orange, green and purple from the nearest on; dark grey outside the shadow map.
        /// </summary>
        Cascades,

        /// <summary>The shadow map's texels as a chequerboard, blue up to a pixel wide, vermilion from eight.</summary>
        ShadowTexels,

        /// <summary>
        /// The width of the penumbra across the light: dark red is 1 cm, orange 10 cm, white 1 m and more. It is blue
        /// where the penumbra is narrower than a texel, where a tent filter or a larger shadow map would serve as well.
        /// </summary>
        PenumbraWidth,

        /// <summary>
        /// The penumbra mask: yellow where it lets the filter run, grey where it skips it; all is yellow without a
        /// mask. Tiled PCSS has none: the tiles that it decides without its filter are not shown.
        /// </summary>
        PenumbraMask,
    }
}
