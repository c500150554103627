namespace UnityEngine.Rendering
{
    [Flags]
    public enum ClearFlag { None = 0, Color = 1 << 0 }

    public class RTHandle
    {
        [OwnBehaviour] public RTHandle() { }
        [OwnBehaviour] public string What { get; set; }
        [OwnBehaviour] public RenderTextureDescriptor Descriptor { get; set; }
        [OwnBehaviour] public bool Released { get; private set; }

        public RenderTexture rt { get; } = new RenderTexture();

        public void Release() => Released = true;

        public static implicit operator RenderTargetIdentifier(RTHandle handle) =>
            new RenderTargetIdentifier { What = handle.What };
    }

    public static class CoreUtils
    {
        /// <summary>The scene views whose light bulb is off.</summary>
        [OwnBehaviour] public static readonly HashSet<Camera> Unlit = new();

        public static Material CreateEngineMaterial(Shader shader) => new Material(shader);

        public static void Destroy(Object obj)
        {
            if (obj != null) obj.Destroyed = true;
        }

        public static bool IsSceneLightingDisabled(Camera camera) => Unlit.Contains(camera);

        public static void SetRenderTarget(CommandBuffer cmd, RTHandle buffer, RenderBufferLoadAction loadAction,
                                           RenderBufferStoreAction storeAction, ClearFlag clearFlag, Color clearColor,
                                           int miplevel = 0, CubemapFace cubemapFace = CubemapFace.Unknown,
                                           int depthSlice = -1)
        {
            cmd.Target(buffer.What, miplevel, depthSlice, loadAction);
            if (clearFlag != ClearFlag.None) cmd.Record(static (device, colour) => device.Clear(colour), clearColor);
        }
    }

    public static class CommandBufferPool
    {
        private static readonly Stack<CommandBuffer> free = new();

        public static CommandBuffer Get() => free.Count > 0 ? free.Pop() : new CommandBuffer();

        public static void Release(CommandBuffer buffer)
        {
            buffer.Clear();
            free.Push(buffer);
        }
    }

    public class ProfilingSampler { public ProfilingSampler(string name) { } }

    public struct ProfilingScope : IDisposable
    {
        public ProfilingScope(CommandBuffer cmd, ProfilingSampler sampler) { }

        public void Dispose() { }
    }
}

namespace UnityEngine.Experimental.Rendering
{
    using UnityEngine.Rendering;

    public class XRPass
    {
        [OwnBehaviour] public int Views { get; set; }

        public bool enabled => viewCount > 0;
        public int viewCount => Views;
        public int multipassId { get; [OwnBehaviour] set; }
        public bool singlePassEnabled => viewCount > 1;

        public void StartSinglePass(CommandBuffer cmd) => Set(cmd, true);

        public void StopSinglePass(CommandBuffer cmd) => Set(cmd, false);

        private void Set(CommandBuffer commands, bool on)
        {
            if (!singlePassEnabled) return;
            commands.Record(static (device, value) => device.SetKeyword("STEREO_INSTANCING_ON", value), on);
        }
    }
}
