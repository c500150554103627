using System;
using System.Collections.Generic;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// A store for each camera that draws, and for each of its eyes where they are drawn one after the other; until it has
    /// not drawn for a while.
    /// </summary>
    internal sealed class CameraStores : IDisposable
    {
        internal const int IdleFrames = 120;

        private readonly Dictionary<(Camera camera, int pass), CameraStore> stores =
            new Dictionary<(Camera camera, int pass), CameraStore>();
        private readonly List<(Camera camera, int pass)> idle = new List<(Camera camera, int pass)>();
        private int sweptAt;

        /// <param name="pass">Of the passes of XR that the camera draws its picture in.</param>
        internal CameraStore Of(Camera camera, int pass)
        {
            int now = Time.frameCount;
            if (!stores.TryGetValue((camera, pass), out CameraStore store))
                stores[(camera, pass)] = store = new CameraStore();
            store.LastFrame = now;
            if (now - sweptAt >= IdleFrames) Sweep(now);
            return store;
        }

        private void Sweep(int now)
        {
            sweptAt = now;
            foreach (KeyValuePair<(Camera camera, int pass), CameraStore> store in stores)
                if (now - store.Value.LastFrame >= IdleFrames) idle.Add(store.Key);
            foreach ((Camera camera, int pass) key in idle)
            {
                stores[key].Dispose();
                stores.Remove(key);
            }
            idle.Clear();
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            foreach (CameraStore store in stores.Values) store.Dispose();
            stores.Clear();
        }
    }
}
