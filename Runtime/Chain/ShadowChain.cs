using System;
using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>
    /// A full-screen draw by a pass of the shader, or what a ShadowPass records itself. Textures are indices into
    /// ShadowChain.Slots; None where it reads none.
    /// </summary>
    internal struct ChainStep
    {
        /// <summary>Null where `recorder` has the step.</summary>
        internal string shaderPass;

        internal ShadowPass recorder;

        /// <summary>Which of the recorder's.</summary>
        internal int run;

        internal int source;
        internal int target;
    }

    /// <summary>A texture that every step behind the one that wrote it finds under a global name.</summary>
    internal struct ChainGlobal
    {
        internal int texture;
        internal int property;
        internal int afterStep;
    }

    /// <summary>
    /// The steps of a frame and the textures between them, made anew only when the options change. Passes speak of
    /// textures by number, as many as they like; Finish() puts those that are not alive together into one slot.
    /// Slot 0 is the screen-space shadow texture that receivers read.
    /// </summary>
    internal sealed class ShadowChain
    {
        internal const int None = -1;
        internal const int Output = 0;

        /// <summary>Of the slots' textures, in order: as many as a chain may need.</summary>
        internal static readonly string[] SlotNames =
        {
            "_ScreenSpaceShadowmapTexture", "_PenumbraSlot1", "_PenumbraSlot2", "_PenumbraSlot3", "_PenumbraSlot4",
            "_PenumbraSlot5", "_PenumbraSlot6", "_PenumbraSlot7",
        };

        private readonly List<ChainStep> steps = new List<ChainStep>();
        private readonly List<ChainTexture> textures = new List<ChainTexture>();
        private readonly List<ChainTexture> slots = new List<ChainTexture>();
        private readonly List<ChainGlobal> globals = new List<ChainGlobal>();
        private readonly List<ShadowPass> passes = new List<ShadowPass>();
        private List<string> keywords;

        internal IReadOnlyList<ChainStep> Steps => steps;
        internal IReadOnlyList<ChainTexture> Slots => slots;
        internal IReadOnlyList<ChainGlobal> Globals => globals;
        internal IReadOnlyList<ShadowPass> Passes => passes;

        /// <summary>Of ChainKeywords.All those that are on in every draw; a pass minds the ones it declares.</summary>
        internal IReadOnlyList<string> Keywords => keywords;

        /// <summary>Where the visibility is by now; None before the resolve.</summary>
        internal int Visibility { get; private set; } = None;

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
            chain.keywords = ChainKeywords.Of(new[] { TechniqueTable.Keywords[(int)options.technique] }, chain.passes);
            return chain;
        }

        /// <summary>A draw over the screen into a texture of its own, whose number it returns.</summary>
        internal int Draw(string shaderPass, int divisor, int source = None) =>
            Draw(shaderPass, ChainTexture.OfScreen(divisor), source);

        internal int Draw(string shaderPass, in ChainTexture texture, int source = None) =>
            Add(new ChainStep { shaderPass = shaderPass, source = source }, texture);

        /// <summary>What `recorder` records itself, its `run`; into a texture of its own, whose number it returns.</summary>
        internal int Run(ShadowPass recorder, int run, in ChainTexture texture, int source = None) =>
            Add(new ChainStep { recorder = recorder, run = run, source = source }, texture);

        private int Add(ChainStep step, in ChainTexture texture)
        {
            textures.Add(texture);
            step.target = textures.Count - 1;
            steps.Add(step);
            return step.target;
        }

        internal void SetVisibility(int texture) { Visibility = texture; }

        /// <summary>`texture`, as it is now, for all steps from here on and for who draws after the chain.</summary>
        internal void Publish(int texture, int property) =>
            globals.Add(new ChainGlobal { texture = texture, property = property, afterStep = steps.Count - 1 });

        /// <summary>The slot that Publish has put under the name; None without.</summary>
        internal int Published(int property)
        {
            foreach (ChainGlobal global in globals)
                if (global.property == property) return global.texture;
            return None;
        }

        private void Finish()
        {
            if (Visibility == None) throw new InvalidOperationException("no pass of the chain makes a visibility");
            if (textures[Visibility].extent != ChainExtent.Screen || textures[Visibility].divisor != 1)
                throw new InvalidOperationException("the chain ends below the screen's resolution");
            if (steps[steps.Count - 1].target != Visibility)
                throw new InvalidOperationException("the chain's last step is not its visibility");
            int[] slotOf = SlotAssignment.Assign(steps, textures, globals, slots);
            if (slots.Count > SlotNames.Length)
                throw new InvalidOperationException("the chain needs " + slots.Count + " textures at once");
            for (int i = 0; i < steps.Count; ++i)
            {
                ChainStep step = steps[i];
                step.source = step.source == None ? None : slotOf[step.source];
                step.target = slotOf[step.target];
                steps[i] = step;
            }
            for (int i = 0; i < globals.Count; ++i)
            {
                ChainGlobal global = globals[i];
                global.texture = slotOf[global.texture];
                globals[i] = global;
            }
            Visibility = slotOf[Visibility];
        }
    }
}
