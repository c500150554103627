using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// The store of one camera's content between frames: textures with persistent content or that the pipeline cannot
    /// lend, and buffers.
    /// </summary>
    internal sealed class CameraStore : IDisposable
    {
        private const int WordBytes = 4;

        private readonly SlotTextures owned = new SlotTextures();
        private ShadowChain chain;
        private bool isFilled;

        // Whether the two textures of each history are swapped for the next frame.
        private bool isSwapped;
        private float filledWidthScale;
        private float filledHeightScale;

        /// <summary>
        /// The textures in the order of the chain's slots; null where the pipeline lends a texture for each frame.
        /// </summary>
        internal RTHandle[] Textures { get; private set; } = Array.Empty<RTHandle>();

        /// <summary>The buffers in the order of the chain's.</summary>
        internal GraphicsBuffer[] Buffers { get; private set; } = Array.Empty<GraphicsBuffer>();

        /// <summary>
        /// Allocates what is missing or has another size, and sets in the frame whether the content is missing.
        /// </summary>
        internal void Prepare(ShadowChain forChain, in RenderTextureDescriptor target, ref ShadowFrame frame)
        {
            if (forChain != chain) Begin(forChain);
            for (int i = 0; i < Textures.Length; ++i)
            {
                if (!chain.Slots[i].IsOwned) continue;
                RenderTextureDescriptor texture = UrpFrame.Texture(target, chain.Slots[i], frame);
                if (owned.Allocate(i, texture, chain.SlotNames[i])) isFilled = false;
                Textures[i] = owned[i];
            }
            for (int i = 0; i < Buffers.Length; ++i)
                if (Allocate(ref Buffers[i], chain.Buffers[i], frame)) isFilled = false;
            // After a change of scale, the device gives textures of the screen other memory.
            if (chain.KeepsScreen && IsScaledAnew(frame)) isFilled = false;
            if (isSwapped) SwapHistories();
            frame.storeIsEmpty = !isFilled;
            // The faces of a probe are different views with the same camera in the same frame, so none has a history.
            frame.historiesAreEmpty = !isFilled || frame.isProbe;
        }

        /// <summary>
        /// Records that the whole chain has been recorded: the current content becomes the history of the next frame.
        /// </summary>
        internal void SetFilled(in ShadowFrame frame)
        {
            isFilled = true;
            isSwapped = !isSwapped;
            filledWidthScale = frame.widthScale;
            filledHeightScale = frame.heightScale;
        }

        private bool IsScaledAnew(in ShadowFrame frame) =>
            filledWidthScale != frame.widthScale || filledHeightScale != frame.heightScale;

        private void SwapHistories()
        {
            for (int i = 0; i < chain.Histories.Count; ++i)
            {
                ChainHistory history = chain.Histories[i];
                Textures[history.now] = owned[history.before];
                Textures[history.before] = owned[history.now];
            }
        }

        private void Begin(ShadowChain forChain)
        {
            Dispose();
            chain = forChain;
            owned.MakeRoom(chain.Slots.Count);
            Textures = new RTHandle[chain.Slots.Count];
            Buffers = new GraphicsBuffer[chain.Buffers.Count];
        }

        // Buffers only grow, so that dynamic resolution does not reallocate them.
        private bool Allocate(ref GraphicsBuffer buffer, in GraphBuffer declared, in ShadowFrame frame)
        {
            int words = declared.words;
            if (declared.texture != ShadowChain.None)
            {
                TextureSize size = TextureSize.Of(chain.Slots[declared.texture], frame);
                words += declared.wordsPerTexel * declared.Blocks(size.width) * declared.Blocks(size.height) * size.depth;
            }
            if (buffer != null && buffer.count >= words) return false;
            buffer?.Release();
            // Direct3D 11 has no structured buffers of arguments: kernels write these as a RWByteAddressBuffer.
            GraphicsBuffer.Target uses = declared.indirect
                                             ? GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.IndirectArguments
                                             : GraphicsBuffer.Target.Structured;
            buffer = new GraphicsBuffer(uses, words, WordBytes);
            return true;
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            owned.Dispose();
            foreach (GraphicsBuffer buffer in Buffers) buffer?.Release();
            Textures = Array.Empty<RTHandle>();
            Buffers = Array.Empty<GraphicsBuffer>();
            chain = null;
            isFilled = isSwapped = false;
        }
    }
}
