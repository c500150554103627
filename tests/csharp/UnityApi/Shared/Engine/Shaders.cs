using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class Shader : Object
    {
        private static readonly List<string> properties = new();

        /// <summary>The shaders that Find() finds.</summary>
        [OwnBehaviour] public static readonly Dictionary<string, Shader> Known = new();

        /// <summary>The names of the passes, in order.</summary>
        [OwnBehaviour] public List<string> PassNames { get; } = new();

        [OwnBehaviour] public static string PropertyName(int id) => properties[id];

        [OwnBehaviour] public Shader() { }

        /// <summary>The local keywords that the shader declares; null means whatever one asks for.</summary>
        [OwnBehaviour] public List<string> KeywordNames { get; set; }

        public bool isSupported { get; [OwnBehaviour] set; } = true;

        public LocalKeywordSpace keywordSpace => new LocalKeywordSpace(KeywordNames);

        [OwnBehaviour] public static Dictionary<string, object> Globals { get; } = new();

        public static Vector4 GetGlobalVector(string name) =>
            Globals.TryGetValue(name, out object value) ? (Vector4)value : default;

        public static Vector4 GetGlobalVector(int nameID) => GetGlobalVector(PropertyName(nameID));

        public static Matrix4x4[] GetGlobalMatrixArray(string name) =>
            Globals.TryGetValue(name, out object value) ? (Matrix4x4[])value : null;

        public static Shader Find(string name) => Known.TryGetValue(name, out Shader shader) ? shader : null;

        public static int PropertyToID(string name)
        {
            if (!properties.Contains(name)) properties.Add(name);
            return properties.IndexOf(name);
        }
    }

    public sealed partial class ComputeShader : Object
    {
        [OwnBehaviour]
        public sealed class Kernel
        {
            public string Name;
            public uint X, Y, Z;
            public bool IsSupported = true;
        }

        [OwnBehaviour] public List<Kernel> Kernels { get; } = new();

        /// <summary>The keywords that the kernel's file declares.</summary>
        [OwnBehaviour] public List<string> KeywordNames { get; set; } = new();

        [OwnBehaviour] public ComputeShader() { }

        public LocalKeywordSpace keywordSpace => new LocalKeywordSpace(KeywordNames);

        public int FindKernel(string name) => Kernels.FindIndex(kernel => kernel.Name == name);

        public bool HasKernel(string name) => FindKernel(name) >= 0;

        public bool IsSupported(int kernelIndex) => Kernels[kernelIndex].IsSupported;

        public void GetKernelThreadGroupSizes(int kernelIndex, out uint x, out uint y, out uint z)
        {
            x = Kernels[kernelIndex].X;
            y = Kernels[kernelIndex].Y;
            z = Kernels[kernelIndex].Z;
        }
    }

    public partial class Material : Object
    {
        public Material(Shader shader) { this.shader = shader; }

        public Shader shader { get; set; }

        public int FindPass(string passName) => shader.PassNames.IndexOf(passName);
    }

    public sealed partial class MaterialPropertyBlock { }
}

namespace UnityEngine.Rendering
{
    public readonly struct GlobalKeyword
    {
        public string name { get; }

        public GlobalKeyword(string name) { this.name = name; }

        public static GlobalKeyword Create(string name) => new GlobalKeyword(name);
    }

    public readonly struct LocalKeyword : IEquatable<LocalKeyword>
    {
        public string name { get; }
        public bool isValid => name != null;

        public LocalKeyword(Shader shader, string name) { this.name = name; }

        [OwnBehaviour] public LocalKeyword(string name) { this.name = name; }

        public bool Equals(LocalKeyword rhs) => name == rhs.name;
    }

    public readonly struct LocalKeywordSpace : IEquatable<LocalKeywordSpace>
    {
        private readonly List<string> declared;

        [OwnBehaviour] public LocalKeywordSpace(List<string> declared) { this.declared = declared; }

        public LocalKeyword FindKeyword(string name) =>
            declared == null || declared.Contains(name) ? new LocalKeyword(name) : default;

        public bool Equals(LocalKeywordSpace rhs) => declared == rhs.declared;
    }
}
