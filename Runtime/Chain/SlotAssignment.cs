using System.Collections.Generic;
using System.Linq;

namespace Penumbra
{
    /// <summary>The lifetime of a texture: the steps of a chain during which its content is needed.</summary>
    internal struct TextureUse
    {
        internal int firstWrite;
        internal int lastUse;
    }

    /// <summary>
    /// Assigns every texture of a chain to a slot: equal textures whose lifetimes do not overlap share one. The
    /// result has slot 0, which textures whose lifetime ends before it is written may also use.
    /// </summary>
    internal static class SlotAssignment
    {
        /// <summary>Fills `slots` and returns each texture's slot.</summary>
        internal static int[] Assign(IReadOnlyList<ChainTexture> textures, IReadOnlyList<TextureUse> uses, int output,
                                     List<ChainTexture> slots)
        {
            var slotOf = new int[textures.Count];
            var freeFrom = new List<int> { 0 };  // per slot: the first step that may overwrite it
            slots.Clear();
            slots.Add(textures[output]);
            foreach (int texture in Enumerable.Range(0, textures.Count).OrderBy(one => uses[one].firstWrite))
            {
                if (texture == output) continue;
                int first = uses[texture].lastUse < uses[output].firstWrite ? ShadowChain.Output : ShadowChain.Output + 1;
                int slot = FreeSlot(slots, freeFrom, textures[texture], first, uses[texture].firstWrite);
                if (slot == slots.Count)
                {
                    slots.Add(textures[texture]);
                    freeFrom.Add(0);
                }
                slotOf[texture] = slot;
                freeFrom[slot] = uses[texture].lastUse + 1;
            }
            slotOf[output] = ShadowChain.Output;
            return slotOf;
        }

        private static int FreeSlot(List<ChainTexture> slots, List<int> freeFrom, in ChainTexture texture, int first,
                                    int at)
        {
            for (int slot = first; slot < slots.Count; ++slot)
                if (slots[slot].Equals(texture) && freeFrom[slot] <= at) return slot;
            return slots.Count;
        }
    }
}
