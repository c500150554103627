namespace Penumbra
{
    /// <summary>
    /// The way in which a device stores the screen, as SystemInfo and GL.GetGPUProjectionMatrix describe it: the
    /// conventions needed to convert a texel and its stored depth to clip space.
    /// </summary>
    public readonly struct ScreenConventions
    {
        /// <summary>
        /// Whether texel row 0 is the top of clip space, y = +1 (SystemInfo.graphicsUVStartsAtTop: Direct3D, Metal,
        /// Vulkan); otherwise it is the bottom, y = -1 (OpenGL).
        /// </summary>
        public readonly bool UvStartsAtTop;

        /// <summary>
        /// Whether clip space's depth is 0 to 1 and stored unchanged; otherwise it is -1 to 1, stored as (z + 1) / 2
        /// (OpenGL).
        /// </summary>
        public readonly bool DepthIsZeroToOne;

        public ScreenConventions(bool uvStartsAtTop, bool depthIsZeroToOne)
        {
            UvStartsAtTop = uvStartsAtTop;
            DepthIsZeroToOne = depthIsZeroToOne;
        }

        public static ScreenConventions Direct3D => new ScreenConventions(true, true);
        public static ScreenConventions OpenGL => new ScreenConventions(false, false);
    }
}
