using System.Globalization;

namespace Penumbra.Editor
{
    /// <summary>Describes a preset's options, and its figures measured under the light of the nearest size.</summary>
    internal static class PresetText
    {
        internal static string Describe(in ShadowOptions options)
        {
            string text = DescribeOne(options);
            return ChainSubstitute.TryGetSampled(options, out ShadowOptions instead)
                       ? text + "; on devices that cannot run it " + TechniqueName.Of(instead.technique) + Passes(instead) + "."
                       : text + ".";
        }

        // The text leaves out the technique that stands in for it on some devices.
        private static string DescribeOne(in ShadowOptions options)
        {
            string text = TechniqueName.Of(options.technique) + ", " + Cost(options);
            if (options.HalvesResolution) text += ", at half resolution";
            return text + Passes(options);
        }

        private static string Passes(in ShadowOptions options) =>
            !options.technique.Entry().takesSamples ? "" :
            (options.mask ? ", where the mask finds a penumbra" : "") + (options.denoise ? ", denoised" : "");

        /// <summary>
        /// A text such as "Error 0.08 in penumbrae, 35.3 fetches per pixel, measured under 2 degrees."
        /// </summary>
        internal static string Figures(QualityPreset preset, float degrees)
        {
            PresetFigure figure = Nearest(PresetFigures.Rows[(int)preset], degrees);
            return string.Format(CultureInfo.InvariantCulture,
                                 "Error {0:0.###} in penumbrae, {1:0.#} fetches per pixel, measured under {2:0.##} degrees.",
                                 figure.penumbraRmse, figure.fetches, figure.lightDegrees);
        }

        // The nearest figure is that by ratio: a light of 1 degree is nearer to 0.53 than to 2.
        private static PresetFigure Nearest(PresetFigure[] figures, float degrees)
        {
            PresetFigure nearest = figures[0];
            foreach (PresetFigure figure in figures)
                if (Ratio(figure.lightDegrees, degrees) < Ratio(nearest.lightDegrees, degrees)) nearest = figure;
            return nearest;
        }

        private static float Ratio(float a, float b) => a > b ? a / System.Math.Max(b, 1e-3f) : b / a;

        /// <summary>
        /// A text such as "PCSS at 0 degrees": the technique's name, with a note if the light's size makes shadows
        /// hard.
        /// </summary>
        internal static string Technique(ShadowOptions options) =>
            TechniqueName.Of(options.technique) + (options.technique.Entry().takesSamples && !options.SamplesPenumbrae ? " at 0 degrees" : "");

        private static string Cost(in ShadowOptions options)
        {
            switch (options.technique)
            {
                case ShadowTechnique.Tent3x3: return "4 fetches of the shadow map, no contact hardening";
                case ShadowTechnique.Tent5x5: return "9 fetches of the shadow map, no contact hardening";
                case ShadowTechnique.Tent7x7: return "16 fetches of the shadow map, no contact hardening";
                case ShadowTechnique.PcssPoisson:
                    return options.blockerSamples + " blocker and as many filter samples";
                default: return options.blockerSamples + " blocker and " + options.filterSamples + " filter samples";
            }
        }
    }
}
