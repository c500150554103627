using System.Collections.Generic;
using System.Linq;

namespace Penumbra
{
    /// <summary>Which graphs options need.</summary>
    internal static class ChainGraphs
    {
        private const int Mask = 1;
        private const int Half = 2;
        private const int Denoise = 4;

        // The passes over the screen, by these bits. The filter is the technique's keyword's affair: the graphs of the
        // study that differ in it alone are the same here.
        private static readonly TechniqueGraph[] ofScreen =
        {
            PenumbraShadowsGraphs.Pcss, PenumbraShadowsGraphs.PcssMasked, PenumbraShadowsGraphs.PcssHalf,
            PenumbraShadowsGraphs.PcssMaskedHalf, PenumbraShadowsGraphs.PcssDenoised,
            PenumbraShadowsGraphs.PcssMaskedDenoised, PenumbraShadowsGraphs.PcssHalfDenoised,
            PenumbraShadowsGraphs.PcssMaskedHalfDenoised,
        };

        /// <summary>All that options may need.</summary>
        internal static IEnumerable<TechniqueGraph> All => ofScreen.Concat(TechniquePasses.Graphs.Values);

        /// <summary>In the order in which they run.</summary>
        internal static IReadOnlyList<TechniqueGraph> Of(in ShadowOptions options)
        {
            TechniqueGraph screen = ofScreen[ScreenBits(options)];
            if (!TechniquePasses.Graphs.TryGetValue(options.technique, out TechniqueGraph own)) return new[] { screen };
            return own.visibility == TechniqueGraph.None ? new[] { own, screen } : new[] { own };
        }

        /// <summary>The same of options that need the same graphs and keywords.</summary>
        internal static int Key(in ShadowOptions options) => (int)options.technique << 3 | ScreenBits(options);

        // A mask costs as much as a filter that takes no samples, and such a filter has no noise.
        private static int ScreenBits(in ShadowOptions options) =>
            (options.mask && options.SamplesPenumbrae ? Mask : 0) | (options.halfResolution ? Half : 0) |
            (options.denoise && options.SamplesPenumbrae ? Denoise : 0);
    }
}
