using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>Textures of a chain's slots that persist between frames.</summary>
    internal sealed class SlotTextures : IDisposable
    {
        private struct Slot
        {
            internal RTHandle texture;
            internal int slices;
        }

        private Slot[] slots = Array.Empty<Slot>();

        /// <summary>The slot's texture; null if not allocated.</summary>
        internal RTHandle this[int slot] => slots[slot].texture;

        internal void MakeRoom(int count)
        {
            if (slots.Length < count) Array.Resize(ref slots, count);
        }

        /// <summary>
        /// Allocates the slot's texture. True if it has no content: it is new, or the device has lost the content.
        /// </summary>
        internal bool Allocate(int index, in RenderTextureDescriptor descriptor, string name)
        {
            ref Slot slot = ref slots[index];
            // URP before 17.5 does not compare the number of slices.
            if (slot.texture != null && slot.slices != descriptor.volumeDepth) Release(ref slot);
            slot.slices = descriptor.volumeDepth;
#if UNITY_6000_0_OR_NEWER
            bool isNew = RenderingUtils.ReAllocateHandleIfNeeded(ref slot.texture, descriptor, FilterMode.Bilinear,
                                                                 TextureWrapMode.Clamp, name: name);
#else
            bool isNew = RenderingUtils.ReAllocateIfNeeded(ref slot.texture, descriptor, FilterMode.Bilinear,
                                                           TextureWrapMode.Clamp, name: name);
#endif
            return isNew || !slot.texture.rt.IsCreated();
        }

        private static void Release(ref Slot slot)
        {
            slot.texture?.Release();
            slot.texture = null;
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            for (int i = 0; i < slots.Length; ++i) Release(ref slots[i]);
        }
    }
}
