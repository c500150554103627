namespace Penumbra
{
    /// <summary>Selects what is drawn instead where a device cannot run the passes that options need.</summary>
    internal static class ChainSubstitute
    {
        /// <summary>
        /// Gives `instead`: the same options with what is drawn in the place of the technique's own passes, if that
        /// takes samples, so that options without an effect on those passes have one on it: the bounded PCSS for
        /// Tiled PCSS.
        /// Otherwise the result is false.
        /// </summary>
        internal static bool TryGetSampled(in ShadowOptions options, out ShadowOptions instead)
        {
            instead = options;
            instead.technique = options.technique.Entry().fallback;
            return options.HasPasses && Has(options.technique) && instead.technique.Entry().takesSamples;
        }

        /// <summary>Whether a filter of the shadow map alone stands in for the technique's passes.</summary>
        internal static bool Has(ShadowTechnique technique) => technique.Entry().fallback != technique;

        /// <summary>
        /// The options that need less of the device: the mask of four taps, then maps of 16 bits, then the fallback of
        /// a technique with passes, then no clouds, then no mean
        /// over frames, then a tent in the place of a filter that needs shader target 4.5.
        /// False if these options have none.
        /// </summary>
        internal static bool TryGet(in ShadowOptions options, out ShadowOptions instead)
        {
            instead = options;
            if (options.MasksConservatively) instead.conservativeMask = false;
            else if (options.HasMapFormats && options.mapFormat == MapFormat.Bits32) instead.mapFormat = MapFormat.Bits16;
            else if (options.HasPasses && Has(options.technique))
                instead.technique = options.technique.Entry().fallback;
            else if (options.clouds) instead.clouds = false;
            else if (options.Accumulates) instead.accumulates = false;
            else if (options.technique.Entry().needsTarget45 && Has(options.technique))
                instead.technique = options.technique.Entry().fallback;
            else return false;
            return true;
        }
    }
}
