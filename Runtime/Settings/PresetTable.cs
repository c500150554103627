namespace Penumbra
{
    // The options of the quality presets, in QualityPreset's order.
    // Written by `penumbra validate --emit-presets` from ShaderLibrary/techniques.json; do not edit.
    internal static class PresetTable
    {
        internal static readonly ShadowOptions[] Rows =
        {
            new ShadowOptions  // Preset Low: Tent 5x5
            {
                technique = ShadowTechnique.Tent5x5,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 1,
                filterSamples = 1,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                mask = false,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset Medium: PCSS 12+8, masked
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 12,
                filterSamples = 8,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                mask = true,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset High: PCSS 24+16, masked
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 24,
                filterSamples = 16,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                mask = true,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset Ultra: PCSS 24+16, masked and denoised
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 24,
                filterSamples = 16,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                mask = true,
                halfResolution = false,
                denoise = true,
            },
            new ShadowOptions  // Preset Reference: PCSS 64+64
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 64,
                filterSamples = 64,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                mask = false,
                halfResolution = false,
                denoise = false,
            },
        };
    }
}
