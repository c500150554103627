using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>Textures of a chain's slots that stay from frame to frame.</summary>
    internal sealed class SlotTextures : IDisposable
    {
        private struct Slot
        {
            internal RTHandle texture;
            internal int slices;
        }

        private Slot[] slots = Array.Empty<Slot>();

        /// <summary>Null: not allocated.</summary>
        internal RTHandle this[int slot] => slots[slot].texture;

        internal void MakeRoom(int count)
        {
            if (slots.Length < count) Array.Resize(ref slots, count);
        }

        /// <summary>True when the slot's texture holds nothing: it is another one, or the device has lost its content.</summary>
        internal bool Allocate(int index, in RenderTextureDescriptor descriptor, string name)
        {
            ref Slot slot = ref slots[index];
            // URP before 17.5 takes textures of other numbers of slices for equal.
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
