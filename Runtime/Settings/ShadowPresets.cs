namespace Penumbra
{
    /// <summary>The options behind each preset's name. What they cost and how wrong they are: PresetFigures.</summary>
    public static class ShadowPresets
    {
        /// <summary>The sun's disc, degrees.</summary>
        public const float SunDegrees = 0.53f;

        /// <summary>Custom has no options of its own: it begins as Medium.</summary>
        public static ShadowOptions Options(QualityPreset preset)
        {
            switch (preset)
            {
                case QualityPreset.Low:
                    return Tent(ShadowTechnique.Tent5x5);
                case QualityPreset.High:
                    return Pcss(24, 16, mask: true, denoise: true);
                case QualityPreset.Ultra:
                    return Pcss(32, 32, mask: false, denoise: true);
                case QualityPreset.Reference:
                    return Pcss(64, 64, mask: false, denoise: false);
                default:
                    return Pcss(12, 8, mask: true, denoise: true);
            }
        }

        private static ShadowOptions Tent(ShadowTechnique technique) => new ShadowOptions
        {
            technique = technique,
            angularDiameterDegrees = SunDegrees,
            blockerSamples = 1,
            filterSamples = 1,
            softnessCapMetres = 100.0f,
            minFilterTexels = 1.25f,
        };

        private static ShadowOptions Pcss(int blockers, int filter, bool mask, bool denoise) => new ShadowOptions
        {
            technique = ShadowTechnique.Pcss,
            angularDiameterDegrees = SunDegrees,
            blockerSamples = blockers,
            filterSamples = filter,
            softnessCapMetres = 100.0f,
            minFilterTexels = 1.25f,
            mask = mask,
            denoise = denoise,
        };
    }
}
