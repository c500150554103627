using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// A store for each camera, and for each eye if they are drawn one after the other. It is released when the camera
    /// has not drawn for a number of frames.
    /// </summary>
    internal sealed class CameraStores : IDisposable
    {
        internal const int IdleFrames = 120;

        private readonly RecentlyUsed<(Camera camera, int pass), CameraStore> stores =
            new RecentlyUsed<(Camera camera, int pass), CameraStore>(IdleFrames);

        /// <param name="pass">The index of the XR pass (multipassId); each eye has its own in multi-pass
        /// mode.</param>
        internal CameraStore Of(Camera camera, int pass) => stores.Of((camera, pass));

        /// <inheritdoc/>
        public void Dispose() => stores.Dispose();
    }
}
