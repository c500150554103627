using System.Runtime.CompilerServices;

namespace UnityEngine.Experimental.Rendering
{
    [Flags]
    public enum GraphicsFormatUsage { Linear = 1 << 1, Render = 1 << 4, LoadStore = 1 << 10 }
}

namespace UnityEngine
{
    public sealed partial class SystemInfo
    {
        public static bool IsFormatSupported(Experimental.Rendering.GraphicsFormat format,
                                             Experimental.Rendering.GraphicsFormatUsage usage) =>
            format != Unsupported &&
            !(usage == Experimental.Rendering.GraphicsFormatUsage.Linear && Unfiltered.Contains(format));
    }
}

namespace UnityEngine.Rendering
{
    public enum GraphicsDeviceType { OpenGLES3 = 11, OpenGLCore = 17, Vulkan = 21, WebGPU = 28 }

    [AttributeUsage(AttributeTargets.Class)]
    public class SupportedOnRenderPipelineAttribute : Attribute
    {
        public SupportedOnRenderPipelineAttribute(params Type[] renderPipeline) { }
    }

    public interface IRenderPipelineGraphicsSettings { }

    public sealed partial class GraphicsSettings
    {
        [OwnBehaviour]
        public static Dictionary<Type, IRenderPipelineGraphicsSettings> Settings { get; } = new();

        public static T GetRenderPipelineSettings<T>() where T : class, IRenderPipelineGraphicsSettings =>
            Settings.TryGetValue(typeof(T), out IRenderPipelineGraphicsSettings found) ? (T)found : null;
    }

    [AttributeUsage(AttributeTargets.Class)]
    public class VolumeComponentMenu : Attribute
    {
        public readonly string menu;

        public VolumeComponentMenu(string menu) { this.menu = menu; }
    }

    public abstract class ContextItem { public abstract void Reset(); }

    public class ContextContainer : IDisposable
    {
        [OwnBehaviour] public Dictionary<Type, ContextItem> Items { get; } = new();

        public T Get<T>() where T : ContextItem, new() => (T)Items[typeof(T)];

        public void Dispose() { }
    }

    public partial class UnsafeCommandBuffer
    {
        [OwnBehaviour] public UnsafeCommandBuffer() { }
        [OwnBehaviour] public CommandBuffer Wrapped { get; set; }
    }

    /// <summary>Draws into the attachment of its pass.</summary>
    public partial class RasterCommandBuffer
    {
        [OwnBehaviour] public RasterCommandBuffer() { }
        [OwnBehaviour] public CommandBuffer Wrapped { get; set; }

        public void SetGlobalVector(int nameID, Vector4 value) => Wrapped.SetGlobalVector(nameID, value);

        public void SetKeyword(in GlobalKeyword keyword, bool value) => Wrapped.SetKeyword(keyword, value);

        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
                                   int vertexCount, int instanceCount, MaterialPropertyBlock properties) =>
            Wrapped.DrawProcedural(matrix, material, shaderPass, topology, vertexCount, instanceCount, properties);
    }

    public struct CommandBufferHelpers
    {
        public static CommandBuffer GetNativeCommandBuffer(UnsafeCommandBuffer baseBuffer) => baseBuffer.Wrapped;
    }
}

namespace UnityEngine.Rendering.RenderGraphModule
{
    [Flags]
    public enum AccessFlags { None = 0, Read = 1 << 0, Write = 1 << 1, ReadWrite = Read | Write }

    public struct TextureHandle
    {
        [OwnBehaviour] public RTHandle Handle { get; set; }

        public bool IsValid() => Handle != null;

        public static implicit operator RTHandle(TextureHandle texture) => texture.Handle;
    }

    public struct RendererListHandle
    {
        [OwnBehaviour] public bool Valid { get; set; }
        [OwnBehaviour] public RendererList List { get; set; }

        public bool IsValid() => Valid;

        public static implicit operator RendererList(RendererListHandle rendererList) => rendererList.List;
    }

    public class UnsafeGraphContext { public UnsafeCommandBuffer cmd; }

    public partial struct RasterGraphContext { public RasterCommandBuffer cmd; }

    public delegate void BaseRenderFunc<PassData, ContextType>(PassData data, ContextType renderGraphContext)
        where PassData : class, new();

    public interface IBaseRenderGraphBuilder : IDisposable
    {
        void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read);
        void SetGlobalTextureAfterPass(in TextureHandle input, int propertyId);
        void UseRendererList(in RendererListHandle input);
        void AllowPassCulling(bool value);
        void AllowGlobalStateModification(bool value);
    }

    public interface IUnsafeRenderGraphBuilder : IBaseRenderGraphBuilder
    {
        void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
            where PassData : class, new();
    }

    public interface IRasterRenderGraphBuilder : IBaseRenderGraphBuilder
    {
        void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags = AccessFlags.Write);
        void SetRenderFunc<PassData>(BaseRenderFunc<PassData, RasterGraphContext> renderFunc)
            where PassData : class, new();
    }

    /// <summary>Keeps what is recorded. Passes and their data are pooled, as the real ones are.</summary>
    public partial class RenderGraph
    {
        [OwnBehaviour]
        public class Pass : IUnsafeRenderGraphBuilder, IRasterRenderGraphBuilder
        {
            public string Name;
            public bool MayBeCulled = true;
            public bool ChangesGlobalState;
            public TextureHandle Attachment;
            public List<(TextureHandle texture, AccessFlags access)> Textures =
                new List<(TextureHandle, AccessFlags)>();
            public bool IsRaster;
            public List<RendererListHandle> Lists = new();
            public List<(TextureHandle texture, int property)> Globals = new List<(TextureHandle, int)>();

            /// <summary>The pass's data; null for a pass of URP's own.</summary>
            public virtual object Data => null;

            public virtual void Run(UnsafeGraphContext context) { }
            public virtual void Run(RasterGraphContext context) { }
            public virtual void GiveBack() { }

            public void UseTexture(in TextureHandle input, AccessFlags flags) => Textures.Add((input, flags));
            public void SetGlobalTextureAfterPass(in TextureHandle input, int propertyId) =>
                Globals.Add((input, propertyId));
            public void UseRendererList(in RendererListHandle input) => Lists.Add(input);
            public void AllowPassCulling(bool value) => MayBeCulled = value;
            public void AllowGlobalStateModification(bool value) => ChangesGlobalState = value;
            public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
                where PassData : class, new() => ((DataPass<PassData>)this).UnsafeWork = renderFunc;
            public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, RasterGraphContext> renderFunc)
                where PassData : class, new() => ((DataPass<PassData>)this).RasterWork = renderFunc;
            public void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags) => Attachment = tex;
            public void Dispose() { }
        }

        private sealed class DataPass<PassData> : Pass where PassData : class, new()
        {
            private static readonly Stack<DataPass<PassData>> pool = new();
            internal readonly PassData OwnData = new PassData();
            internal BaseRenderFunc<PassData, UnsafeGraphContext> UnsafeWork;
            internal BaseRenderFunc<PassData, RasterGraphContext> RasterWork;

            internal static DataPass<PassData> Take() => pool.Count > 0 ? pool.Pop() : new DataPass<PassData>();

            public override object Data => OwnData;
            public override void Run(UnsafeGraphContext context) => UnsafeWork(OwnData, context);
            public override void Run(RasterGraphContext context) => RasterWork(OwnData, context);

            public override void GiveBack()
            {
                Textures.Clear();
                Globals.Clear();
                Lists.Clear();
                MayBeCulled = true;
                ChangesGlobalState = false;
                Attachment = default;
                pool.Push(this);
            }
        }

        [OwnBehaviour] public RenderGraph() { }
        [OwnBehaviour] public List<Pass> Passes { get; } = new();

        /// <summary>Ends a camera: its passes serve the next one.</summary>
        [OwnBehaviour]
        public void GiveBack()
        {
            foreach (Pass pass in Passes) pass.GiveBack();
            Passes.Clear();
            foreach (RTHandle texture in lent) free.Push(texture);
            lent.Clear();
        }

        private readonly List<RTHandle> lent = new();
        private readonly Stack<RTHandle> free = new();

        [OwnBehaviour]
        public TextureHandle Lend(string name, in RenderTextureDescriptor descriptor)
        {
            RTHandle texture = free.Count > 0 ? free.Pop() : new RTHandle();
            texture.What = name;
            texture.Descriptor = descriptor;
            lent.Add(texture);
            return new TextureHandle { Handle = texture };
        }

        public RendererListHandle CreateRendererList(in RendererListParams desc) =>
            new RendererListHandle { Valid = true, List = new RendererList { What = desc.Pass } };

        public TextureHandle ImportTexture(RTHandle rt) => new TextureHandle { Handle = rt };

        public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(string passName, out PassData passData,
                                                                 ProfilingSampler sampler,
                                                                 [CallerFilePath] string file = "",
                                                                 [CallerLineNumber] int line = 0)
            where PassData : class, new() => Add(passName, isRaster: false, out passData);

        public IRasterRenderGraphBuilder AddRasterRenderPass<PassData>(string passName, out PassData passData,
                                                                       ProfilingSampler sampler,
                                                                       [CallerFilePath] string file = "",
                                                                       [CallerLineNumber] int line = 0)
            where PassData : class, new() => Add(passName, isRaster: true, out passData);

        private Pass Add<PassData>(string passName, bool isRaster, out PassData passData) where PassData : class, new()
        {
            DataPass<PassData> pass = DataPass<PassData>.Take();
            pass.Name = passName;
            pass.IsRaster = isRaster;
            passData = pass.OwnData;
            Passes.Add(pass);
            return pass;
        }
    }
}

#if UNITY_EDITOR
namespace UnityEngine.Rendering
{
    public interface IStripper { bool active { get; } }
}

namespace UnityEditor.Rendering
{
    public interface IVariantStripper<TShader, TShaderVariant> : UnityEngine.Rendering.IStripper
        where TShader : UnityEngine.Object
    {
        bool CanRemoveVariant(TShader shader, TShaderVariant shaderVariant, ShaderCompilerData shaderCompilerData);
    }

    public interface IShaderVariantStripper : IVariantStripper<UnityEngine.Shader, ShaderSnippetData> { }

    public partial class VolumeComponentEditor { public bool enableOverrides { get; set; } = true; }
}
#endif
