using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    public partial class Texture : Object
    {
        internal Texture() { }

        public virtual int width { get; set; }
        public virtual int height { get; set; }
    }

    public sealed partial class Texture2D : Texture
    {
        private static readonly Texture2D black = new Texture2D { name = "black" };

        public static Texture2D blackTexture => black;

        [OwnBehaviour] public Texture2D() { }
    }

    public sealed partial class Texture2DArray : Texture
    {
        public Texture2DArray(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags) =>
            name = "array of " + depth;
    }

    public partial class RenderTexture : Texture
    {
        [OwnBehaviour] public RenderTexture() { }

        public RenderTextureFormat format { get; set; }
        public GraphicsFormat graphicsFormat { get; set; }

        /// <summary>Whether the device has lost the texture.</summary>
        [OwnBehaviour] public bool Lost { get; set; }

        public bool IsCreated() => !Lost;
    }

    public struct RenderTextureDescriptor
    {
        public int width { get; set; }
        public int height { get; set; }
        public int msaaSamples { get; set; }
        public int volumeDepth { get; set; }
        public GraphicsFormat graphicsFormat { get; set; }
        public GraphicsFormat depthStencilFormat { get; set; }
        public bool useDynamicScale { get; set; }
        public bool useMipMap { get; set; }
        public bool autoGenerateMips { get; set; }
        public bool bindMS { get; set; }
        public bool enableRandomWrite { get; set; }
        public Rendering.TextureDimension dimension { get; set; }
        public VRTextureUsage vrUsage { get; set; }

        /// <summary>
        /// Whether the handle needs another allocation, as RenderingUtils.RTHandleNeedsReAlloc tells before URP 17.5:
        /// it does not compare slices.
        /// </summary>
        [OwnBehaviour]
        public bool IsSame(in RenderTextureDescriptor other) =>
            width == other.width && height == other.height && msaaSamples == other.msaaSamples &&
            graphicsFormat == other.graphicsFormat && depthStencilFormat == other.depthStencilFormat &&
            useDynamicScale == other.useDynamicScale && useMipMap == other.useMipMap &&
            autoGenerateMips == other.autoGenerateMips && bindMS == other.bindMS &&
            enableRandomWrite == other.enableRandomWrite && dimension == other.dimension;
    }
}

namespace UnityEngine.Rendering
{
    public partial struct RenderTargetIdentifier : IEquatable<RenderTargetIdentifier>
    {
        [OwnBehaviour] public string What { get; set; }

        public static implicit operator RenderTargetIdentifier(Texture tex) =>
            new RenderTargetIdentifier { What = tex.name };

        public bool Equals(RenderTargetIdentifier rhs) => What == rhs.What;
    }
}
