using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// Builds a chain from graphs. It numbers the textures in order; Finish() computes the lifetime of each and
    /// replaces the numbers by slots.
    /// </summary>
    internal sealed class ChainBuilder
    {
        private readonly List<ChainTexture> textures = new List<ChainTexture>();
        private readonly List<ChainTexture> slots = new List<ChainTexture>();
        private readonly List<ChainStep> steps = new List<ChainStep>();
        private readonly List<ChainGlobal> globals = new List<ChainGlobal>();
        private readonly List<ChainHistory> histories = new List<ChainHistory>();
        private int visibility = ShadowChain.None;

        internal IReadOnlyList<ChainStep> Steps => steps;
        internal IReadOnlyList<ChainTexture> Slots => slots;
        internal IReadOnlyList<ChainGlobal> Globals => globals;
        internal IReadOnlyList<ChainHistory> Histories => histories;
        internal int Mask { get; private set; } = ShadowChain.None;

        internal void Add(TechniqueGraph graph)
        {
            var placed = new int[graph.textures.Length];
            int next = textures.Count;
            for (int i = 0; i < placed.Length; ++i) placed[i] = i == graph.source ? Source(graph) : next++;
            for (int i = 0; i < graph.textures.Length; ++i)
            {
                if (i == graph.source) continue;
                // Both textures of a history are written, in alternate frames.
                int previousOf = graph.textures[i].previousOf;
                int written = previousOf == TechniqueGraph.None ? i : previousOf;
                textures.Add(new ChainTexture(graph.textures[i], IsWrittenByKernels(graph, written), IsKept(graph, i),
                                              graph.passes.Any(pass => pass.depth == i), IsFiltered(graph, i)));
                if (written != i) histories.Add(new ChainHistory { now = placed[written], before = placed[i] });
            }
            foreach (GraphPass pass in graph.passes) steps.Add(Step(pass, placed));
            foreach (GraphBinding texture in graph.filterTextures)
                globals.Add(new ChainGlobal { texture = Binding(texture, placed), afterStep = steps.Count - 1 });
            if (graph.visibility != TechniqueGraph.None) visibility = placed[graph.visibility];
            if (graph.mask != TechniqueGraph.None) Mask = placed[graph.mask];
        }

        // The texture of the visibility so far, which the graph reads under a name of its own.
        private int Source(TechniqueGraph graph)
        {
            if (visibility == ShadowChain.None)
                throw new InvalidOperationException("graph '" + graph.name + "' reads the visibility of a graph before it");
            return visibility;
        }

        private static int Place(int index, int[] placed) =>
            index == TechniqueGraph.None ? ShadowChain.None : placed[index];

        private static bool IsWrittenByKernels(TechniqueGraph graph, int texture) =>
            graph.passes.Any(pass => pass.kind == PassKind.Compute && pass.Writes(texture));

        private static bool IsFiltered(TechniqueGraph graph, int texture) =>
            graph.filtersLinearly && graph.filterTextures.Any(binding => binding.index == texture);

        // Whether the texture is read in frames in which no pass writes it.
        private static bool IsKept(TechniqueGraph graph, int texture)
        {
            if (graph.textures[texture].previousOf != TechniqueGraph.None) return true;
            if (graph.textures.Any(other => other.previousOf == texture)) return true;
            PassFrequency written = graph.passes.Where(pass => pass.Writes(texture)).Min(pass => pass.runs);
            bool byFilter = graph.filterTextures.Any(binding => binding.index == texture);
            return byFilter && written < PassFrequency.Frame ||
                   graph.passes.Any(pass => pass.Reads(texture) && pass.runs > written);
        }

        private ChainStep Step(GraphPass pass, int[] placed)
        {
            ChainBinding Bound(GraphBinding binding) => Binding(binding, placed);
            var step = new ChainStep
            {
                pass = pass, reads = pass.reads.Select(Bound).ToArray(),
                writes = pass.writes.Concat(pass.updates).Select(Bound).ToArray(),
                absent = pass.absent.Select(Shader.PropertyToID).ToArray(),
                absentSizes = pass.absent.Select(SizeProperty).ToArray(),
            };
            step.depth = Place(pass.depth, placed);
            if (pass.kind == PassKind.Compute) step.threadsOf = Place(pass.groups.texelsOf, placed);
            for (int i = 0; i < step.reads.Length; ++i)
                if (pass.eachMip && pass.Writes(pass.reads[i].index))
                    step.reads[i].levels = LevelCopies(textures[step.reads[i].index]);
            return step;
        }

        private static ChainBinding Binding(in GraphBinding binding, int[] placed)
        {
            ChainBinding bound = default;
            bound.index = placed[binding.index];
            if (binding.property == null) return bound;
            bound.property = Shader.PropertyToID(binding.property);
            bound.sizeProperty = SizeProperty(binding.property);
            return bound;
        }

        private static int SizeProperty(string texture) => Shader.PropertyToID(SizeName(texture));

        // The name of a texture's size: that of _PenumbraSourceTexture is _PenumbraSourceSize.
        private static string SizeName(string texture)
        {
            const string ending = "Texture";
            return (texture.EndsWith(ending, StringComparison.Ordinal)
                        ? texture.Substring(0, texture.Length - ending.Length)
                        : texture) + "Size";
        }

        // The copies of the mip levels that a pass reads, each while it draws the next level.
        private int[] LevelCopies(in ChainTexture texture)
        {
            var copies = new int[(texture.mips == 0 ? MostLevels : texture.mips) - 1];
            for (int level = 0; level < copies.Length; ++level)
            {
                copies[level] = textures.Count;
                textures.Add(texture.CopyOf(level));
            }
            return copies;
        }

        private const int MostLevels = 15;  // levels of a texture of 16384 texels

        internal void Finish()
        {
            if (visibility == ShadowChain.None)
                throw new InvalidOperationException("no graph of the chain outputs a visibility texture");
            int[] slotOf = SlotAssignment.Assign(textures, Uses(), visibility, slots);
            foreach (ChainStep step in steps)
            {
                PutSlots(step.reads, slotOf);
                PutSlots(step.writes, slotOf);
                if (step.threadsOf != ShadowChain.None) step.threadsOf = slotOf[step.threadsOf];
                if (step.depth != ShadowChain.None) step.depth = slotOf[step.depth];
            }
            for (int i = 0; i < globals.Count; ++i)
            {
                ChainGlobal global = globals[i];
                global.texture.index = slotOf[global.texture.index];
                globals[i] = global;
            }
            for (int i = 0; i < histories.Count; ++i)
                histories[i] = new ChainHistory
                {
                    now = slotOf[histories[i].now], before = slotOf[histories[i].before],
                };
            if (Mask != ShadowChain.None) Mask = slotOf[Mask];
        }

        // The mask stays alive to the end, because a debug view shows it, and so do the textures that the filter
        // reads by name.
        private TextureUse[] Uses()
        {
            var uses = Enumerable.Repeat(new TextureUse { firstWrite = steps.Count, lastUse = -1 }, textures.Count)
                .ToArray();
            void Use(int texture, int first, int last)
            {
                uses[texture].firstWrite = Math.Min(uses[texture].firstWrite, first);
                uses[texture].lastUse = Math.Max(uses[texture].lastUse, last);
            }
            for (int at = 0; at < steps.Count; ++at)
            {
                foreach (ChainBinding write in steps[at].writes) Use(write.index, at, at);
                if (steps[at].depth != ShadowChain.None) Use(steps[at].depth, at, at);
                foreach (ChainBinding read in steps[at].reads)
                {
                    Use(read.index, at, at);
                    foreach (int copy in read.levels ?? Array.Empty<int>()) Use(copy, at, at);
                }
            }
            foreach (ChainGlobal global in globals) uses[global.texture.index].lastUse = steps.Count;
            if (Mask != ShadowChain.None) uses[Mask].lastUse = steps.Count;
            uses[visibility].lastUse = steps.Count;
            return uses;
        }

        private static void PutSlots(ChainBinding[] bindings, int[] slotOf)
        {
            for (int i = 0; i < bindings.Length; ++i)
            {
                bindings[i].index = slotOf[bindings[i].index];
                for (int level = 0; level < (bindings[i].levels?.Length ?? 0); ++level)
                    bindings[i].levels[level] = slotOf[bindings[i].levels[level]];
            }
        }
    }
}
