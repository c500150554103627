namespace UnityEditor.Rendering;

public enum ShaderCompilerPlatform { None = 0, D3D = 4, GLES3x = 9, OpenGLCore = 15, Vulkan = 18, WebGPU = 26 }
