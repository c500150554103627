namespace Penumbra
{
    /// <summary>
    /// The filters' parameters in user units. Defaults are those of the manifest
    /// (ShaderLibrary/Filters/Pcss/PcssAngular.technique.json): PCSS with 24 and 16 samples.
    /// <para>Values out of range are allowed here: their readers clamp them, as the shaders do.</para>
    /// </summary>
    public struct SoftShadowParameters
    {
        /// <summary>Full angle of the light's disc, degrees, 0 to 30.</summary>
        public float AngularDiameterDegrees;

        /// <summary>
        /// Fetches of the blocker search, 1 to 128; PCSS (Poisson) has as many in the filter, and allows up to 128.
        /// </summary>
        public int BlockerSamples;

        /// <summary>Fetches of the filter, 1 to 128.</summary>
        public int FilterSamples;

        /// <summary>
        /// Radial distribution of the search samples, 0 to 8: 0 puts equally many into each octave of radius, 1 spreads
        /// them uniformly over the area, 2 has a density of 1/r. PCSS (HDRP) takes at least 1.
        /// </summary>
        public float BlockerClump;

        /// <summary>Smallest filter and search radius, texels, 0 to 64.</summary>
        public float MinFilterTexels;

        /// <summary>Widest penumbra, from dark to lit, metres.</summary>
        public float MaxPenumbraMetres;

        /// <summary>Height of the light's cone above the receiver, beyond which it is a cylinder, metres.</summary>
        public float MaxSamplingMetres;

        /// <summary>Radius of the blocker search of PCSS (Poisson), across the light, metres.</summary>
        public float SearchRadiusMetres;

        /// <summary>
        /// Border in which a cascade is dithered with the next: share of the split sphere's radius, 0 to 1.
        /// </summary>
        public float CascadeBorder;

        /// <summary>
        /// Angular diameter of the blocker search of PCSS (HDRP), degrees, 0 to 90; not less than the light's.
        /// </summary>
        public float HdrpSearchDegrees;

        /// <summary>
        /// Angular diameter of the cone below the smallest filter radius of PCSS (HDRP), degrees, 0 to 90; not less
        /// than the search's.
        /// </summary>
        public float HdrpMinFilterDegrees;

        /// <summary>Parameters for the sun: PCSS with the sun's angular diameter.</summary>
        public static SoftShadowParameters Default => new SoftShadowParameters
        {
            AngularDiameterDegrees = AngularDiameter.SunDegrees, BlockerSamples = 24, FilterSamples = 16,
            BlockerClump = 0.0f, MinFilterTexels = 1.25f, MaxPenumbraMetres = 100.0f, MaxSamplingMetres = 1000.0f,
            SearchRadiusMetres = 0.5f, HdrpSearchDegrees = 12.0f, HdrpMinFilterDegrees = 10.0f,
        };

        /// <summary>HDRP's own defaults, for PCSS (HDRP) (_PENUMBRA_PCSS_HDRP).</summary>
        public static SoftShadowParameters HdrpDefault
        {
            get
            {
                var parameters = Default;
                parameters.BlockerClump = 2.0f;
                parameters.MinFilterTexels = 1.5f;
                parameters.MaxPenumbraMetres = 0.56f;
                parameters.MaxSamplingMetres = 0.5f;
                return parameters;
            }
        }
    }
}
