using System;
using System.Collections.Generic;
using System.Linq;

namespace Penumbra
{
    /// <summary>
    /// A texture that is bound under a global name for all later steps and for draws after the chain.
    /// </summary>
    internal struct ChainGlobal
    {
        internal ChainBinding texture;
        internal int afterStep;
    }

    /// <summary>
    /// The chain that a frame runs: the passes of one or more graphs, and the textures between them. Textures whose
    /// lifetimes do not overlap share a slot. Slot 0 is the screen-space shadow texture that receivers read.
    /// </summary>
    internal sealed class ShadowChain
    {
        internal const int None = TechniqueGraph.None;
        internal const int Output = 0;
        internal const string OutputName = "_ScreenSpaceShadowmapTexture";

        internal IReadOnlyList<ChainStep> Steps { get; }
        internal IReadOnlyList<ChainTexture> Slots { get; }

        /// <summary>The names of the slots' textures.</summary>
        internal IReadOnlyList<string> SlotNames { get; }

        internal IReadOnlyList<ChainGlobal> Globals { get; }
        internal IReadOnlyList<ChainHistory> Histories { get; }

        /// <summary>
        /// The keywords of ChainKeywords.All that are enabled; each program uses those that it declares.
        /// </summary>
        internal IReadOnlyList<string> Keywords { get; }

        /// <summary>The mask's slot; None without one.</summary>
        internal int Mask { get; }

        /// <summary>Whether a texture that is kept between frames has the size of the screen.</summary>
        internal bool KeepsScreen { get; }

        /// <summary>Whether the step's target has a slice per eye if two are drawn at once.</summary>
        internal bool IsOverScreen(ChainStep step) => Slots[step.Target].extent == GraphExtent.Screen;

        /// <summary>
        /// Whether a step draws objects of the scene; DrawsCascades tells whether one of them does so per cascade.
        /// </summary>
        internal bool DrawsObjects { get; }
        internal bool DrawsCascades { get; }

        /// <summary>The chain that these options need.</summary>
        internal static ShadowChain Of(in ShadowOptions options) =>
            new ShadowChain(ChainGraphs.Of(options), options.technique.Entry().keyword);

        /// <summary>The chain of what these options draw beyond the cascades, where nothing casts into them.</summary>
        internal static ShadowChain OverLit(in ShadowOptions options) => new ShadowChain(ChainGraphs.OverLit(options), null);

        /// <param name="graphs">In order; the last one outputs a visibility texture.</param>
        /// <param name="techniqueKeyword">Null: none.</param>
        internal ShadowChain(IReadOnlyList<TechniqueGraph> graphs, string techniqueKeyword)
        {
            var builder = new ChainBuilder();
            foreach (TechniqueGraph graph in graphs) builder.Add(graph);
            builder.Finish();
            Steps = builder.Steps;
            Slots = builder.Slots;
            Globals = builder.Globals;
            Histories = builder.Histories;
            Mask = builder.Mask;
            SlotNames = Enumerable.Range(0, Slots.Count)
                .Select(slot => slot == Output ? OutputName : "_PenumbraSlot" + slot).ToArray();
            KeepsScreen = Slots.Any(slot => slot.kept && slot.extent == GraphExtent.Screen);
            DrawsObjects = Steps.Any(step => step.pass.kind == PassKind.Casters);
            DrawsCascades = Steps.Any(step => step.pass.kind == PassKind.Casters && step.ByCascade);
            Keywords = ChainKeywords.Of(techniqueKeyword, graphs);
        }
    }
}
