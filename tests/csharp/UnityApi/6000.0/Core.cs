using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Penumbra.UnityApi;

namespace UnityEngine.Experimental.Rendering
{
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/GraphicsEnums.cs")]
    [Flags]
    public enum GraphicsFormatUsage { Render = 1 << 4, LoadStore = 1 << 10 }
}

namespace UnityEngine
{
    public sealed partial class SystemInfo
    {
        public static bool IsFormatSupported(Experimental.Rendering.GraphicsFormat format,
                                             Experimental.Rendering.GraphicsFormatUsage usage) =>
            format != Unsupported;
    }
}

namespace UnityEngine.Rendering
{
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/SupportedOnRenderPipeline.cs")]
    [AttributeUsage(AttributeTargets.Class)]
    public class SupportedOnRenderPipelineAttribute : Attribute
    {
        public SupportedOnRenderPipelineAttribute(params Type[] renderPipeline) { }
    }

    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/IRenderPipelineGraphicsSettings.cs")]
    public interface IRenderPipelineGraphicsSettings
    {
    }

    public sealed partial class GraphicsSettings
    {
        [OwnBehaviour]
        public static Dictionary<Type, IRenderPipelineGraphicsSettings> Settings { get; } =
            new Dictionary<Type, IRenderPipelineGraphicsSettings>();

        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/GraphicsSettings.RenderPipelineGlobalSettings.bindings.cs")]
        public static T GetRenderPipelineSettings<T>() where T : class, IRenderPipelineGraphicsSettings =>
            Settings.TryGetValue(typeof(T), out IRenderPipelineGraphicsSettings found) ? (T)found : null;
    }

    [ReadFrom(At.Core17, "core", "Runtime/Volume/VolumeComponent.cs")]
    [AttributeUsage(AttributeTargets.Class)]
    public class VolumeComponentMenu : Attribute
    {
        public VolumeComponentMenu(string menu) { }
    }

    [ReadFrom(At.Core17, "core", "Runtime/Common/ContextContainer.cs")]
    public abstract class ContextItem
    {
        public abstract void Reset();
    }

    [ReadFrom(At.Core17, "core", "Runtime/Common/ContextContainer.cs")]
    public class ContextContainer : IDisposable
    {
        [OwnBehaviour] public Dictionary<Type, ContextItem> Items { get; } = new Dictionary<Type, ContextItem>();

        public T Get<T>() where T : ContextItem, new() => (T)Items[typeof(T)];

        public void Dispose() { }
    }

    [ReadFrom(At.Core17, "core", "Runtime/CommandBuffers/UnsafeCommandBuffer.cs")]
    public partial class UnsafeCommandBuffer
    {
        [OwnBehaviour] public UnsafeCommandBuffer() { }
        [OwnBehaviour] public CommandBuffer Wrapped { get; set; }
    }

    /// <summary>Draws into the attachment of its pass.</summary>
    [ReadFrom(At.Core17, "core", "Runtime/CommandBuffers/RasterCommandBuffer.cs")]
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

    [ReadFrom(At.Core17, "core", "Runtime/CommandBuffers/CommandBufferHelpers.cs")]
    public struct CommandBufferHelpers
    {
        public static CommandBuffer GetNativeCommandBuffer(UnsafeCommandBuffer baseBuffer) => baseBuffer.Wrapped;
    }
}

namespace UnityEngine.Rendering.RenderGraphModule
{
    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/RenderGraph.cs")]
    [Flags]
    public enum AccessFlags
    {
        None = 0,
        Read = 1 << 0,
        Write = 1 << 1,
        ReadWrite = Read | Write,
    }

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/RenderGraphResourceTexture.cs")]
    public struct TextureHandle
    {
        [OwnBehaviour] public RTHandle Handle { get; set; }

        public bool IsValid() => Handle != null;

        public static implicit operator RTHandle(TextureHandle texture) => texture.Handle;
    }

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/RenderGraph.cs")]
    public class UnsafeGraphContext
    {
        public UnsafeCommandBuffer cmd;
    }

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/RenderGraph.cs")]
    public partial struct RasterGraphContext
    {
        public RasterCommandBuffer cmd;
    }

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/RenderGraph.cs")]
    public delegate void BaseRenderFunc<PassData, ContextType>(PassData data, ContextType renderGraphContext)
        where PassData : class, new();

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/IRenderGraphBuilder.cs")]
    public interface IBaseRenderGraphBuilder : IDisposable
    {
        void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read);
        void SetGlobalTextureAfterPass(in TextureHandle input, int propertyId);
        void AllowPassCulling(bool value);
        void AllowGlobalStateModification(bool value);
    }

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/IRenderGraphBuilder.cs")]
    public interface IUnsafeRenderGraphBuilder : IBaseRenderGraphBuilder
    {
        void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
            where PassData : class, new();
    }

    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/IRenderGraphBuilder.cs")]
    public interface IRasterRenderGraphBuilder : IBaseRenderGraphBuilder
    {
        void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags = AccessFlags.Write);
        void SetRenderFunc<PassData>(BaseRenderFunc<PassData, RasterGraphContext> renderFunc)
            where PassData : class, new();
    }

    /// <summary>Keeps what is recorded; Run() does it.</summary>
    [ReadFrom(At.Core17, "core", "Runtime/RenderGraph/RenderGraph.cs")]
    public partial class RenderGraph
    {
        [OwnBehaviour]
        public sealed class Pass : IUnsafeRenderGraphBuilder, IRasterRenderGraphBuilder
        {
            public string Name;
            public object Data;
            public bool MayBeCulled = true;
            public bool ChangesGlobalState;
            public Action<UnsafeGraphContext> Work;
            public Action<RasterGraphContext> RasterWork;
            public TextureHandle Attachment;
            public List<(TextureHandle texture, AccessFlags access)> Textures =
                new List<(TextureHandle, AccessFlags)>();
            public bool IsRaster;
            public List<(TextureHandle texture, int property)> Globals = new List<(TextureHandle, int)>();

            public void UseTexture(in TextureHandle input, AccessFlags flags) => Textures.Add((input, flags));
            public void SetGlobalTextureAfterPass(in TextureHandle input, int propertyId) =>
                Globals.Add((input, propertyId));
            public void AllowPassCulling(bool value) => MayBeCulled = value;
            public void AllowGlobalStateModification(bool value) => ChangesGlobalState = value;
            public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
                where PassData : class, new() => Work = context => renderFunc((PassData)Data, context);
            public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, RasterGraphContext> renderFunc)
                where PassData : class, new() => RasterWork = context => renderFunc((PassData)Data, context);
            public void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags) => Attachment = tex;
            public void Dispose() { }
        }

        [OwnBehaviour] public RenderGraph() { }
        [OwnBehaviour] public List<Pass> Passes { get; } = new List<Pass>();

        public TextureHandle ImportTexture(RTHandle rt) => new TextureHandle { Handle = rt };

        public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(string passName, out PassData passData,
                                                                 ProfilingSampler sampler,
                                                                 [CallerFilePath] string file = "",
                                                                 [CallerLineNumber] int line = 0)
            where PassData : class, new()
        {
            return Add(passName, isRaster: false, out passData);
        }

        public IRasterRenderGraphBuilder AddRasterRenderPass<PassData>(string passName, out PassData passData,
                                                                       ProfilingSampler sampler,
                                                                       [CallerFilePath] string file = "",
                                                                       [CallerLineNumber] int line = 0)
            where PassData : class, new()
        {
            return Add(passName, isRaster: true, out passData);
        }

        private Pass Add<PassData>(string passName, bool isRaster, out PassData passData)
            where PassData : class, new()
        {
            passData = new PassData();
            var pass = new Pass { Name = passName, Data = passData, IsRaster = isRaster };
            Passes.Add(pass);
            return pass;
        }
    }
}

#if UNITY_EDITOR
namespace UnityEngine.Rendering
{
    [ReadFrom(At.Core17, "core", "Runtime/Stripping/IStripper.cs")]
    public interface IStripper
    {
        bool active { get; }
    }
}

namespace UnityEditor.Rendering
{
    [ReadFrom(At.Core17, "core", "Editor/ShaderStripping/IVariantStripper.cs")]
    public interface IVariantStripper<TShader, TShaderVariant> : UnityEngine.Rendering.IStripper
        where TShader : UnityEngine.Object
    {
        bool CanRemoveVariant(TShader shader, TShaderVariant shaderVariant, ShaderCompilerData shaderCompilerData);
    }

    [ReadFrom(At.Core17, "core", "Editor/ShaderStripping/IVariantStripper.cs")]
    public interface IShaderVariantStripper : IVariantStripper<UnityEngine.Shader, ShaderSnippetData>
    {
    }

    public partial class VolumeComponentEditor
    {
        public bool enableOverrides { get; set; } = true;
    }
}
#endif
