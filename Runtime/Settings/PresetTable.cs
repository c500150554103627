namespace Penumbra
{
    // Written by `penumbra emit` from the technique list; do not edit.
    /// <summary>The options of the quality presets, in QualityPreset's order.</summary>
    internal static class PresetTable
    {
        internal static readonly ShadowOptions[] Rows =
        {
            // Penumbra Low
            new ShadowOptions
            {
                technique = ShadowTechnique.TiledPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 8, filterSamples = 16, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false, halfResolution = true,
                denoise = false
            },
            // Penumbra Medium
            new ShadowOptions
            {
                technique = ShadowTechnique.TiledPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 12, filterSamples = 22, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false, halfResolution = false,
                denoise = false
            },
            // Penumbra High
            new ShadowOptions
            {
                technique = ShadowTechnique.TiledPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 32, filterSamples = 32, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false, halfResolution = false,
                denoise = false
            },
            // Penumbra Ultra
            new ShadowOptions
            {
                technique = ShadowTechnique.TiledPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 64, filterSamples = 64, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false, halfResolution = false,
                denoise = false
            },
            // Penumbra Reference
            new ShadowOptions
            {
                technique = ShadowTechnique.TiledPcss, angularDiameterDegrees = AngularDiameter.SunDegrees,
                blockerSamples = 128, filterSamples = 128, softnessCapMetres = 100.0f, minFilterTexels = 1.25f,
                lightBleeding = 0.2f, mapBlurTexels = 1.5f, rays = 7, samplesPerRay = 8, discRadiusMetres = 0.05f,
                mapFormat = MapFormat.Bits32, mask = false, conservativeMask = false, halfResolution = false,
                denoise = false
            },
        };
    }
}
