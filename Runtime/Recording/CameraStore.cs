using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// The store of one camera's textures: those whose content persists between frames or that the pipeline cannot
    /// lend.
    /// </summary>
    internal sealed class CameraStore : IDisposable
    {
        private readonly SlotTextures owned = new SlotTextures();
        private ShadowChain chain;
        private bool isFilled;

        // Whether the two textures of each history are swapped for the next frame.
        private bool isSwapped;
        private float filledWidthScale;
        private float filledHeightScale;
        private Matrix4x4 filledScreenToWorld0;
        private Matrix4x4 filledScreenToWorld1;

        /// <summary>
        /// The textures in the order of the chain's slots; null where the pipeline lends a texture for each frame.
        /// </summary>
        internal RTHandle[] Textures { get; private set; } = Array.Empty<RTHandle>();

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
            filledScreenToWorld0 = frame.screenToWorld0;
            filledScreenToWorld1 = frame.screenToWorld1;
        }

        /// <summary>Sets in the frame how its screen maps to that of the frame before, if the chain has histories.</summary>
        internal void SetPreviousScreen(ref ShadowFrame frame)
        {
            if (chain.Histories.Count == 0) return;
            frame.toPreviousScreen0 = frame.toPreviousScreen1 = Matrix4x4.identity;
            if (frame.historiesAreEmpty) return;
            frame.toPreviousScreen0 = ScreenToWorld.Between(frame.screenToWorld0, filledScreenToWorld0);
            frame.toPreviousScreen1 = ScreenToWorld.Between(frame.screenToWorld1, filledScreenToWorld1);
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
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            owned.Dispose();
            Textures = Array.Empty<RTHandle>();
            chain = null;
            isFilled = isSwapped = false;
        }
    }
}
