namespace UnityEngine.Experimental.Rendering
{
    public enum FormatUsage { Linear = 1, Render = 4, LoadStore = 10 }
}

namespace UnityEngine
{
    public sealed partial class SystemInfo
    {
        public static bool IsFormatSupported(Experimental.Rendering.GraphicsFormat format,
                                             Experimental.Rendering.FormatUsage usage) =>
            format != Unsupported &&
            !(usage == Experimental.Rendering.FormatUsage.Linear && Unfiltered.Contains(format));
    }
}

namespace UnityEngine.Rendering
{
    public enum GraphicsDeviceType { OpenGLES3 = 11, OpenGLCore = 17, Vulkan = 21 }

    [AttributeUsage(AttributeTargets.Class)]
    public class VolumeComponentMenu : Attribute
    {
        public readonly string menu;

        public VolumeComponentMenu(string menu) { this.menu = menu; }
    }

    public class VolumeComponentMenuForRenderPipeline : VolumeComponentMenu
    {
        public VolumeComponentMenuForRenderPipeline(string menu, params Type[] pipelineTypes) : base(menu) { }
    }
}

namespace UnityEditor.Rendering
{
    public interface IVariantStripper<TShader, TShaderVariant> where TShader : UnityEngine.Object
    {
        bool active { get; }

        bool CanRemoveVariant(TShader shader, TShaderVariant shaderVariant, ShaderCompilerData shaderCompilerData);
    }

    public interface IShaderVariantStripper : IVariantStripper<UnityEngine.Shader, ShaderSnippetData> { }
}
