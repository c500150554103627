using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>
    /// Gives every texture of a chain a slot: equal textures that are not alive at the same time share it. The
    /// last draw's, which is the result, has slot 0; what nobody reads any more by then may lie there before it.
    /// </summary>
    internal static class SlotAssignment
    {
        /// <summary>Fills `slots` and returns each texture's slot. What is published lives to the end.</summary>
        internal static int[] Assign(List<ChainStep> steps, List<ChainTexture> textures, List<ChainGlobal> globals,
                                     List<ChainTexture> slots)
        {
            int[] lastRead = LastReads(steps, textures.Count);
            foreach (ChainGlobal global in globals) lastRead[global.texture] = steps.Count;
            var slotOf = new int[textures.Count];
            var freeFrom = new List<int> { 0 };  // of each slot: the first step that may write it again
            slots.Clear();
            slots.Add(textures[steps[steps.Count - 1].target]);
            int last = steps.Count - 1;
            for (int at = 0; at < last; ++at)
            {
                int texture = steps[at].target;
                int first = lastRead[texture] < last ? ShadowChain.Output : ShadowChain.Output + 1;
                int slot = FreeSlot(slots, freeFrom, textures[texture], first, at);
                if (slot == slots.Count)
                {
                    slots.Add(textures[texture]);
                    freeFrom.Add(0);
                }
                slotOf[texture] = slot;
                freeFrom[slot] = lastRead[texture] + 1;
            }
            slotOf[steps[last].target] = ShadowChain.Output;
            return slotOf;
        }

        private static int[] LastReads(List<ChainStep> steps, int textures)
        {
            var lastRead = new int[textures];
            for (int at = 0; at < steps.Count; ++at)
            {
                lastRead[steps[at].target] = at;
                if (steps[at].source != ShadowChain.None) lastRead[steps[at].source] = at;
            }
            return lastRead;
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
