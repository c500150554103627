using System;

namespace Penumbra
{
    /// <summary>What Techniques.txt says about a technique of the renderer feature.</summary>
    internal sealed class TechniqueEntry
    {
        /// <summary>
        /// The shader keyword; null for the technique that is used without one. Passes that draw the visibility have
        /// their fallback's.
        /// </summary>
        internal string keyword;

        /// <summary>What is drawn where the technique cannot run; itself if it runs everywhere.</summary>
        internal ShadowTechnique fallback;

        /// <summary>The technique is a filter that samples the light's disc: a mask saves samples, and the denoiser smooths them.</summary>
        internal bool takesSamples;

        /// <summary>Penumbrae are as wide as the light's disc makes them.</summary>
        internal bool widensWithDisc;

        /// <summary>The filter gathers texels or searches for bits, which needs shader target 4.5.</summary>
        internal bool needsTarget45;

        /// <summary>The filter itself limits how wide penumbrae are, in metres.</summary>
        internal bool limitsWidth;

        /// <summary>The filter biases receivers itself: the light's own biases should be 0.</summary>
        internal bool hasOwnBias;

        /// <summary>The options that set a parameter of the passes or filter.</summary>
        internal MeasuredOption[] options = Array.Empty<MeasuredOption>();

        /// <summary>Parameters that the technique's rules change from a cascade on.</summary>
        internal CascadeVector[] cascades = Array.Empty<CascadeVector>();

        /// <summary>One or two formats of its maps: index with ShadowOptions.FormatIndex.</summary>
        internal TechniqueFormat[] formats = Array.Empty<TechniqueFormat>();

        /// <summary>
        /// The passes that draw the visibility at half resolution, in place of those of the format; null: none.
        /// </summary>
        internal TechniqueGraph halfGraph;

        /// <summary>Gives the technique's own options the values that it is measured with.</summary>
        internal void SetMeasured(ref ShadowOptions shadow)
        {
            foreach (MeasuredOption option in options) OptionTable.Set(ref shadow, option.number, option.value);
        }

        /// <summary>Whether this field of ShadowOptions sets a parameter of the technique's passes or filter.</summary>
        internal bool Takes(string option) => Array.Exists(options, taken => taken.name == option);
    }

    /// <summary>An option and the value with which its technique is measured.</summary>
    internal struct MeasuredOption
    {
        internal string name;
        internal NumberOption number;
        internal float value;
    }

    /// <summary>What a technique runs with maps of one format: the second has 16 bits.</summary>
    internal sealed class TechniqueFormat
    {
        /// <summary>
        /// The passes before the filter, which make the maps that it reads, or those that draw the visibility without
        /// one; null for a filter of the shadow map alone.
        /// </summary>
        internal TechniqueGraph graph;

        /// <summary>The uniforms of the passes and the filter, but for those that ShadowUniforms computes.</summary>
        internal ParameterVector[] parameters = Array.Empty<ParameterVector>();
    }
}
