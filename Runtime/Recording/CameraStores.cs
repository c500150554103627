using System;
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

        private readonly RecentlyUsed<(Camera camera, int pass), CameraStore> stores =
            new RecentlyUsed<(Camera camera, int pass), CameraStore>(IdleFrames);

        /// <param name="pass">Of the passes of XR that the camera draws its picture in.</param>
        internal CameraStore Of(Camera camera, int pass) => stores.Of((camera, pass));

        /// <inheritdoc/>
        public void Dispose() => stores.Dispose();
    }
}
