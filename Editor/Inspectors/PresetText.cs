namespace Penumbra.Editor
{
    /// <summary>A preset's options in words.</summary>
    internal static class PresetText
    {
        internal static string Describe(in ShadowOptions options)
        {
            string text = Technique(options);
            if (options.mask && options.technique.TakesSamples()) text += ", where the mask finds a penumbra";
            if (options.halfResolution) text += ", at half resolution";
            if (options.denoise && options.technique.TakesSamples()) text += ", denoised";
            return text + ".";
        }

        private static string Technique(in ShadowOptions options)
        {
            switch (options.technique)
            {
                case ShadowTechnique.Tent3x3: return "Tent 3 x 3, 4 fetches a pixel, no contact hardening";
                case ShadowTechnique.Tent5x5: return "Tent 5 x 5, 9 fetches a pixel, no contact hardening";
                case ShadowTechnique.Tent7x7: return "Tent 7 x 7, 16 fetches a pixel, no contact hardening";
                case ShadowTechnique.PcssPoisson:
                    return "Classic PCSS, " + options.blockerSamples + " blocker and as many filter samples";
                default:
                    return "PCSS, " + options.blockerSamples + " blocker and " + options.filterSamples +
                           " filter samples";
            }
        }
    }
}
