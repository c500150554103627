using System;
using System.Collections.Generic;

namespace Penumbra
{
    /// <summary>All passes there are, in their order, one of each, found once.</summary>
    internal static class ShadowPassList
    {
        private static ShadowPass[] all;

        internal static IReadOnlyList<ShadowPass> All => all ?? (all = Find());

        private static ShadowPass[] Find()
        {
            var found = new List<ShadowPass>();
            foreach (Type type in typeof(ShadowPass).Assembly.GetTypes())
                if (type.IsSubclassOf(typeof(ShadowPass)) && !type.IsAbstract)
                    found.Add((ShadowPass)Activator.CreateInstance(type, nonPublic: true));
            found.Sort((a, b) => a.Order.CompareTo(b.Order));
            return found.ToArray();
        }
    }
}
