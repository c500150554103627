namespace Penumbra
{
    /// <summary>The source from which shadows beyond the shadow distance are computed.</summary>
    public enum FarShadowMode
    {
        /// <summary>No shadows beyond: they fade out at the shadow distance, as URP's do.</summary>
        Off,

        /// <summary>
        /// The heights of a Terrain or of a baked height map, in which each pixel searches towards the sun. This suits
        /// ground that changes.
        /// </summary>
        HeightMap,

        /// <summary>
        /// The angles up to which the ground hides the sky in eight directions, baked into two textures. They suit
        /// ground that does not change, and a sun that is high or near one of those directions: between two of them,
        /// shadows of a low sun are far off.
        /// </summary>
        HorizonAngles,
    }
}
