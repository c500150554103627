using System;
using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>One full-screen draw. Textures are indices into ShadowChain.Slots; None where it reads none.</summary>
    internal struct ChainStep
    {
        internal string shaderPass;
        internal int source;
        internal int mask;
        internal int target;
    }

    /// <summary>A texture of the chain: one in `divisor` of the screen's pixels along each axis.</summary>
    internal readonly struct ChainSlot
    {
        /// <summary>Of the slots' textures, in order: as many as a chain may need.</summary>
        internal static readonly string[] Names =
        {
            "_ScreenSpaceShadowmapTexture", "_PenumbraSlot1", "_PenumbraSlot2", "_PenumbraSlot3", "_PenumbraSlot4",
            "_PenumbraSlot5", "_PenumbraSlot6", "_PenumbraSlot7",
        };

        internal readonly int divisor;

        internal ChainSlot(int divisor) { this.divisor = divisor; }

        /// <summary>Size along one axis: rounded up, so that the last pixels of an odd screen have one too.</summary>
        internal int Size(int screenSize) => Math.Max(1, (screenSize + divisor - 1) / divisor);
    }

    /// <summary>
    /// The draws of a frame and the textures between them, made anew only when the options change. Passes speak of
    /// textures by number, as many as they like; Finish() puts those that are not alive together into one slot.
    /// Slot 0 is the screen-space shadow texture that receivers read.
    /// </summary>
    internal sealed class ShadowChain
    {
        internal const int None = -1;
        internal const int Output = 0;

        private readonly List<ChainStep> steps = new List<ChainStep>();
        private readonly List<int> divisors = new List<int>();
        private readonly List<ChainSlot> slots = new List<ChainSlot>();
        private readonly List<ShadowPass> passes = new List<ShadowPass>();
        private readonly List<string> keywords = new List<string>();

        internal IReadOnlyList<ChainStep> Steps => steps;
        internal IReadOnlyList<ChainSlot> Slots => slots;
        internal IReadOnlyList<ShadowPass> Passes => passes;

        /// <summary>Of TechniqueKeywords.All those that are on in every draw; a pass minds the ones it declares.</summary>
        internal IReadOnlyList<string> Keywords => keywords;

        /// <summary>Where the visibility is by now; None before the resolve.</summary>
        internal int Visibility { get; private set; } = None;

        /// <summary>The finished penumbra mask; None without.</summary>
        internal int Mask { get; private set; } = None;

        /// <summary>The chain of all passes that these options need.</summary>
        internal static ShadowChain Of(in ShadowOptions options, IReadOnlyList<ShadowPass> available)
        {
            var chain = new ShadowChain();
            foreach (ShadowPass pass in available)
            {
                if (!pass.IsNeeded(options)) continue;
                chain.passes.Add(pass);
                pass.AddSteps(chain, options);
            }
            chain.Finish();
            chain.SetKeywords(options.technique);
            return chain;
        }

        /// <summary>A draw into a texture of its own, whose number it returns.</summary>
        internal int Draw(string shaderPass, int divisor, int source = None)
        {
            divisors.Add(divisor);
            int target = divisors.Count - 1;
            steps.Add(new ChainStep { shaderPass = shaderPass, source = source, mask = Mask, target = target });
            return target;
        }

        internal void SetMask(int texture) { Mask = texture; }
        internal void SetVisibility(int texture) { Visibility = texture; }

        private void SetKeywords(ShadowTechnique technique)
        {
            string name = TechniqueKeywords.Names[(int)technique];
            if (name != null) keywords.Add(name);
            if (Mask != None) keywords.Add(TechniqueKeywords.Mask);
        }

        private void Finish()
        {
            if (Visibility == None) throw new InvalidOperationException("no pass of the chain makes a visibility");
            if (divisors[Visibility] != 1)
                throw new InvalidOperationException("the chain ends below the screen's resolution");
            if (steps[steps.Count - 1].target != Visibility)
                throw new InvalidOperationException("the chain's last draw is not its visibility");
            int[] slotOf = SlotAssignment.Assign(steps, divisors, slots);
            if (slots.Count > ChainSlot.Names.Length)
                throw new InvalidOperationException("the chain needs " + slots.Count + " textures at once");
            for (int i = 0; i < steps.Count; ++i)
            {
                ChainStep step = steps[i];
                step.source = step.source == None ? None : slotOf[step.source];
                step.mask = step.mask == None ? None : slotOf[step.mask];
                step.target = slotOf[step.target];
                steps[i] = step;
            }
            Visibility = slotOf[Visibility];
            Mask = Mask == None ? None : slotOf[Mask];
        }
    }
}
