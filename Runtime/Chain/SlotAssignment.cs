using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>
    /// Gives every texture of a chain a slot: textures of one size that are not alive at the same time share it. The
    /// last draw's, which is the result, has slot 0; what nobody reads any more by then may lie there before it.
    /// </summary>
    internal static class SlotAssignment
    {
        /// <summary>Fills `slots` and returns each texture's slot.</summary>
        internal static int[] Assign(List<ChainStep> steps, List<int> divisors, List<ChainSlot> slots)
        {
            int[] lastRead = LastReads(steps, divisors.Count);
            var slotOf = new int[divisors.Count];
            var freeFrom = new List<int> { 0 };  // of each slot: the first step that may write it again
            slots.Clear();
            slots.Add(new ChainSlot(1));
            int last = steps.Count - 1;
            for (int at = 0; at < last; ++at)
            {
                int texture = steps[at].target;
                int first = lastRead[texture] < last ? ShadowChain.Output : ShadowChain.Output + 1;
                int slot = FreeSlot(slots, freeFrom, divisors[texture], first, at);
                if (slot == slots.Count)
                {
                    slots.Add(new ChainSlot(divisors[texture]));
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
                if (steps[at].mask != ShadowChain.None) lastRead[steps[at].mask] = at;
            }
            return lastRead;
        }

        private static int FreeSlot(List<ChainSlot> slots, List<int> freeFrom, int divisor, int first, int at)
        {
            for (int slot = first; slot < slots.Count; ++slot)
                if (slots[slot].divisor == divisor && freeFrom[slot] <= at) return slot;
            return slots.Count;
        }
    }
}
