namespace Penumbra
{
    // The options of the quality presets, in QualityPreset's order.
    // Written by `penumbra validate --emit-presets` from Shaders/PenumbraShadows.technique.json; do not edit.
    internal static class PresetTable
    {
        internal static readonly ShadowOptions[] Rows =
        {
            new ShadowOptions  // Preset Low: PCSS 6+8
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 6,
                filterSamples = 8,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                lightBleeding = 0.2f,
                mapBlurTexels = 1.5f,
                rays = 7,
                samplesPerRay = 8,
                discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32,
                mask = false,
                conservativeMask = false,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset Medium: PCSS 8+16
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 8,
                filterSamples = 16,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                lightBleeding = 0.2f,
                mapBlurTexels = 1.5f,
                rays = 7,
                samplesPerRay = 8,
                discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32,
                mask = false,
                conservativeMask = false,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset High: PCSS 12+24, masked
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 12,
                filterSamples = 24,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                lightBleeding = 0.2f,
                mapBlurTexels = 1.5f,
                rays = 7,
                samplesPerRay = 8,
                discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32,
                mask = true,
                conservativeMask = false,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset Ultra: PCSS 16+32, masked
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 16,
                filterSamples = 32,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                lightBleeding = 0.2f,
                mapBlurTexels = 1.5f,
                rays = 7,
                samplesPerRay = 8,
                discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32,
                mask = true,
                conservativeMask = false,
                halfResolution = false,
                denoise = false,
            },
            new ShadowOptions  // Preset Reference: PCSS 64+64
            {
                technique = ShadowTechnique.Pcss,
                angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 64,
                filterSamples = 64,
                softnessCapMetres = 100.0f,
                minFilterTexels = 1.25f,
                lightBleeding = 0.2f,
                mapBlurTexels = 1.5f,
                rays = 7,
                samplesPerRay = 8,
                discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32,
                mask = false,
                conservativeMask = false,
                halfResolution = false,
                denoise = false,
            },
        };
    }
}
