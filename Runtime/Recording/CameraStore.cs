using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>
    /// What a chain has of one camera from frame to frame: the textures that it keeps or that the pipeline does not
    /// lend, and its buffers.
    /// </summary>
    internal sealed class CameraStore : IDisposable
    {
        private const int WordBytes = 4;

        private ShadowChain chain;
        private bool isFilled;

        /// <summary>In the order of the chain's slots; null where a texture is lent for each frame.</summary>
        internal RTHandle[] Textures { get; private set; } = Array.Empty<RTHandle>();

        /// <summary>In the order of the chain's.</summary>
        internal GraphicsBuffer[] Buffers { get; private set; } = Array.Empty<GraphicsBuffer>();

        /// <summary>Time.frameCount when it was asked for last.</summary>
        internal int LastFrame { get; set; }

        /// <summary>Makes what is not there, or not as large as this frame's. Tells the frame when it is empty.</summary>
        internal void Prepare(ShadowChain forChain, in RenderTextureDescriptor target, ref ShadowFrame frame)
        {
            if (forChain != chain) Begin(forChain);
            for (int i = 0; i < Textures.Length; ++i)
                if (chain.Slots[i].IsOwned && Allocate(ref Textures[i], UrpFrame.Texture(target, chain.Slots[i], frame),
                                                       chain.SlotNames[i])) isFilled = false;
            for (int i = 0; i < Buffers.Length; ++i)
                if (Allocate(ref Buffers[i], chain.Buffers[i], frame)) isFilled = false;
            frame.storeIsEmpty = !isFilled;
        }

        /// <summary>The chain has been recorded whole: what is now is a frame old in the next.</summary>
        internal void SetFilled()
        {
            isFilled = true;
            for (int i = 0; i < chain.Histories.Count; ++i)
            {
                ChainHistory history = chain.Histories[i];
                RTHandle now = Textures[history.now];
                Textures[history.now] = Textures[history.before];
                Textures[history.before] = now;
            }
        }

        private void Begin(ShadowChain forChain)
        {
            Dispose();
            chain = forChain;
            Textures = new RTHandle[chain.Slots.Count];
            Buffers = new GraphicsBuffer[chain.Buffers.Count];
        }

        private static bool Allocate(ref RTHandle texture, in RenderTextureDescriptor descriptor, string name) =>
#if UNITY_6000_0_OR_NEWER
            RenderingUtils.ReAllocateHandleIfNeeded(ref texture, descriptor, FilterMode.Bilinear, TextureWrapMode.Clamp,
                                                    name: name);
#else
            RenderingUtils.ReAllocateIfNeeded(ref texture, descriptor, FilterMode.Bilinear, TextureWrapMode.Clamp,
                                              name: name);
#endif

        // Grows only: dynamic resolution must not allocate.
        private bool Allocate(ref GraphicsBuffer buffer, in GraphBuffer declared, in ShadowFrame frame)
        {
            int words = declared.words;
            if (declared.texture != ShadowChain.None)
            {
                TextureSize size = TextureSize.Of(chain.Slots[declared.texture], frame);
                words += declared.wordsPerTexel * size.width * size.height * size.depth;
            }
            if (buffer != null && buffer.count >= words) return false;
            buffer?.Release();
            GraphicsBuffer.Target uses = GraphicsBuffer.Target.Structured;
            if (declared.indirect) uses |= GraphicsBuffer.Target.IndirectArguments;
            buffer = new GraphicsBuffer(uses, words, WordBytes);
            return true;
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            foreach (RTHandle texture in Textures) texture?.Release();
            foreach (GraphicsBuffer buffer in Buffers) buffer?.Release();
            Textures = Array.Empty<RTHandle>();
            Buffers = Array.Empty<GraphicsBuffer>();
            chain = null;
            isFilled = false;
        }
    }
}
