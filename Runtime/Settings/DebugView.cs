namespace Penumbra
{
    /// <summary>
    /// What is drawn over the camera's picture, in the editor and in development builds; each is a pass of
    /// Shaders/PenumbraDebugViews.shader. Drawn before post-processing, which acts upon it: switch that off for exact
    /// colours.
    /// </summary>
    public enum DebugView
    {
        None,

        /// <summary>The screen-space shadow texture: black 0, white 1.</summary>
        Visibility,

        /// <summary>Sky blue, orange, green, purple from the nearest on; dark grey where no shadow map reaches.</summary>
        Cascades,

        /// <summary>The shadow map's texels as chequers: blue up to a pixel wide, vermilion from eight.</summary>
        ShadowTexels,

        /// <summary>
        /// Width of the penumbra across the light: dark red 1 cm, orange 10 cm, white 1 m and more; blue where it is
        /// narrower than a texel, so that a tent filter or a larger shadow map would do as well.
        /// </summary>
        PenumbraWidth,

        /// <summary>Yellow where the filter runs, grey where the penumbra mask spares it.</summary>
        PenumbraMask,
    }
}
