namespace Penumbra
{
    /// <summary>From what shadows beyond the shadow distance are computed.</summary>
    public enum FarShadowMode
    {
        /// <summary>None: shadows fade out at the shadow distance, as URP's do.</summary>
        Off,

        /// <summary>
        /// From the heights of a Terrain or of a baked height map, by a search towards the sun for each pixel. For
        /// ground that changes.
        /// </summary>
        HeightMap,

        /// <summary>
        /// From the angles up to which the ground hides the sky in eight directions, baked into two textures. For ground that
        /// does not change, and a sun that is high or near one of those directions: between two of them, shadows of a low
        /// sun are far off.
        /// </summary>
        HorizonAngles,
    }
}
