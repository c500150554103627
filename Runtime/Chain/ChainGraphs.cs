using System.Collections.Generic;
using System.Linq;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>Selects the graphs that options need.</summary>
    internal static class ChainGraphs
    {
        private const int Mask = 1;
        private const int Half = 2;
        private const int Denoise = 4;
        private const int Conservative = 8; // only with Mask
        private const int SecondFormat = 16;
        private const int ContactShadows = 32;
        private const int Clouds = 64;
        private const int Accumulate = 128;
        private const int FarShadows = 256;  // times the mode
        private const int Bits = 10;

        // The screen-space passes, indexed by these bits. The filter is selected by the technique's keyword, so
        // graphs of the study that differ only in the filter are the same graph here.
        private static readonly string[] ofScreen =
        {
            "pcss", "pcss-masked", "pcss-half", "pcss-masked-half", "pcss-denoised", "pcss-masked-denoised",
            "pcss-half-denoised", "pcss-masked-half-denoised",
        };

        // The screen-space passes with a conservative mask. All of them have it, so they are indexed without its bits.
        private static readonly string[] ofScreenConservative =
        {
            "pcss-conservative", "pcss-conservative-half", "pcss-conservative-denoised",
            "pcss-conservative-half-denoised",
        };

        // The graphs beyond the cascades by mode, without and with clouds; null stands for none.
        private static readonly string[][] beyondCascades =
        {
            new[] { null, "clouds" }, new[] { "far-heights", "far-heights-clouds" },
            new[] { "far-horizon", "far-horizon-clouds" },
        };

        private const string ScreenTrace = "screen-trace";
        private const string OverFrames = "accumulate";

        /// <summary>The graphs that are not of one technique.</summary>
        internal static IEnumerable<string> Names => ofScreen.Concat(ofScreenConservative).Append(ScreenTrace).Append(OverFrames)
            .Concat(beyondCascades.SelectMany(names => names).Where(name => name != null));

        // This graph stands for the cascades' visibility where nothing casts into them.
        private static readonly TechniqueGraph lit = new TechniqueGraph
        {
            name = "lit",
            textures = new[] { new GraphTexture("visibility", GraphExtent.Screen, GraphicsFormat.R8_UNorm) },
            passes = new[] { new GraphPass { kind = PassKind.Lit, writes = new[] { GraphBinding.Texture(0) } } },
            visibility = 0,
        };

        // Each of these graphs reads the visibility of the graphs before it.
        private static IEnumerable<TechniqueGraph> OverVisibility(ShadowOptions options)
        {
            if (options.HasContactShadows) yield return TechniqueTable.Graph(ScreenTrace);
            if (options.Accumulates) yield return TechniqueTable.Graph(OverFrames);
            if (options.DrawsBeyondCascades) yield return BeyondCascades(options);
        }

        private static TechniqueGraph BeyondCascades(in ShadowOptions options) =>
            TechniqueTable.Graph(beyondCascades[(int)options.farShadows][options.clouds ? 1 : 0]);

        /// <summary>The graphs beyond the cascades alone. A device may be unable to draw any.</summary>
        internal static IReadOnlyList<TechniqueGraph> OverLit(in ShadowOptions options) =>
            options.DrawsBeyondCascades ? new[] { lit, BeyondCascades(options) } : new[] { lit };

        /// <summary>All graphs that any options need.</summary>
        internal static IEnumerable<TechniqueGraph> All => Names.Select(TechniqueTable.Graph)
            .Concat(TechniqueTable.Entries.SelectMany(technique => technique.formats.Select(format => format.graph)
                                                          .Append(technique.halfGraph)).Where(graph => graph != null));

        /// <summary>The graphs that the options need, in the order in which they run.</summary>
        internal static IReadOnlyList<TechniqueGraph> Of(in ShadowOptions options) =>
            OfVisibility(options).Concat(OverVisibility(options)).ToArray();

        private static IEnumerable<TechniqueGraph> OfVisibility(in ShadowOptions options)
        {
            int bits = ScreenBits(options);
            TechniqueGraph screen = TechniqueTable.Graph((bits & Conservative) == 0
                                        ? ofScreen[bits] : ofScreenConservative[(bits & (Half | Denoise)) / Half]);
            if (!options.HasPasses) return new[] { screen };
            TechniqueGraph own = options.OwnGraph;
            return options.DrawsVisibility ? new[] { own } : new[] { own, screen };
        }

        /// <summary>A number that is equal for options that need the same graphs and keywords.</summary>
        internal static int Key(in ShadowOptions options) =>
            (int)options.technique << Bits | (options.FormatIndex > 0 ? SecondFormat : 0) |
            (options.HasContactShadows ? ContactShadows : 0) | (options.Accumulates ? Accumulate : 0) | (options.clouds ? Clouds : 0) |
            FarShadows * (int)options.farShadows | ScreenBits(options);

        // A filter without samples has no noise to remove.
        private static int ScreenBits(in ShadowOptions options) =>
            (options.HasMask ? Mask : 0) | (options.HalvesResolution ? Half : 0) |
            (options.denoise && options.SamplesPenumbrae ? Denoise : 0) |
            (options.MasksConservatively ? Conservative : 0);
    }
}
