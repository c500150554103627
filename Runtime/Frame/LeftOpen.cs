using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Before every camera, restores URP's keywords if the previous camera still had the screen-space keyword on,
    /// because it threw an exception between our two passes. The command goes through the context, so that it runs
    /// after all that camera's commands.
    /// </summary>
    internal static class LeftOpen
    {
        private static readonly HashSet<object> watchers = new HashSet<object>();

        internal static void Watch(object feature)
        {
            if (watchers.Add(feature) && watchers.Count == 1)
                RenderPipelineManager.beginCameraRendering += BeforeCamera;
        }

        internal static void Forget(object feature)
        {
            if (watchers.Remove(feature) && watchers.Count == 0)
                RenderPipelineManager.beginCameraRendering -= BeforeCamera;
        }

        private static void BeforeCamera(ScriptableRenderContext context, Camera camera)
        {
            if (!ShadowKeywords.Global.IsOpen) return;
            CommandBuffer commands = CommandBufferPool.Get();
            ShadowKeywords.Global.Close(commands);
            context.ExecuteCommandBuffer(commands);
            CommandBufferPool.Release(commands);
        }
    }
}
