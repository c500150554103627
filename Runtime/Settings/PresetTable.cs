namespace Penumbra
{
    // Written by `penumbra emit` from the technique list; do not edit.
    /// <summary>The options of the quality presets, in QualityPreset's order.</summary>
    internal static class PresetTable
    {
        internal static readonly ShadowOptions[] Rows =
        {
            // Preset Low: Cell PCSS at half resolution, 3 cells; else Fallback of Low: PCSS 8+16 at half resolution
            new ShadowOptions
            {
                technique = ShadowTechnique.CellPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 8, filterSamples = 16, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                filterCells = 3, mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false,
                halfResolution = true, denoise = false
            },
            // Preset Medium: Cell PCSS, 3 cells; else Fallback of Medium: PCSS 8+16
            new ShadowOptions
            {
                technique = ShadowTechnique.CellPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 8, filterSamples = 16, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                filterCells = 3, mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false,
                halfResolution = false, denoise = false
            },
            // Preset High: Cell PCSS, 4 cells; else Fallback of High: PCSS 12+24, masked
            new ShadowOptions
            {
                technique = ShadowTechnique.CellPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 12, filterSamples = 24, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                filterCells = 4, mapFormat = MapFormat.Bits32, mask = true, conservativeMask = false,
                halfResolution = false, denoise = false
            },
            // Preset Ultra: Cell PCSS, 5 cells; else Fallback of Ultra: PCSS 16+32, masked
            new ShadowOptions
            {
                technique = ShadowTechnique.CellPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 16, filterSamples = 32, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                filterCells = 5, mapFormat = MapFormat.Bits32, mask = true, conservativeMask = false,
                halfResolution = false, denoise = false
            },
            // Preset Reference: PCSS 64+64
            new ShadowOptions
            {
                technique = ShadowTechnique.Pcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 64, filterSamples = 64, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                filterCells = 5, mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false,
                halfResolution = false, denoise = false
            },
        };
    }
}
