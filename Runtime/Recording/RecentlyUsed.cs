using System;
using System.Collections.Generic;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// Creates a value for each key on first use, and disposes of values not used for a number of frames.
    /// </summary>
    internal sealed class RecentlyUsed<TKey, TValue> : IDisposable
        where TKey : IEquatable<TKey> where TValue : class, IDisposable, new()
    {
        private struct Entry
        {
            internal TValue value;
            internal int lastFrame;
        }

        private readonly int idleFrames;
        private readonly Dictionary<TKey, Entry> entries = new Dictionary<TKey, Entry>();
        private readonly List<TKey> idle = new List<TKey>();
        private int sweptAt;

        internal RecentlyUsed(int idleFrames) { this.idleFrames = idleFrames; }

        internal TValue Of(TKey key)
        {
            int now = Time.frameCount;
            if (!entries.TryGetValue(key, out Entry entry)) entry.value = new TValue();
            entry.lastFrame = now;
            entries[key] = entry;
            if (now - sweptAt >= idleFrames) Sweep(now);
            return entry.value;
        }

        private void Sweep(int now)
        {
            sweptAt = now;
            foreach (KeyValuePair<TKey, Entry> entry in entries)
                if (now - entry.Value.lastFrame >= idleFrames) idle.Add(entry.Key);
            foreach (TKey key in idle)
            {
                entries[key].value.Dispose();
                entries.Remove(key);
            }
            idle.Clear();
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            foreach (Entry entry in entries.Values) entry.value.Dispose();
            entries.Clear();
        }
    }
}
