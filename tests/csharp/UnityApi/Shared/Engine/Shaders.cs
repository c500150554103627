using System;
using System.Collections.Generic;
using Penumbra.UnityApi;
using UnityEngine.Rendering;

namespace UnityEngine
{
    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/Shader.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/Shader.bindings.cs")]
    public sealed partial class Shader : Object
    {
        private static readonly List<string> properties = new List<string>();

        /// <summary>What Find() finds.</summary>
        [OwnBehaviour] public static readonly Dictionary<string, Shader> Known = new Dictionary<string, Shader>();

        /// <summary>The names of the passes, in order.</summary>
        [OwnBehaviour] public List<string> PassNames { get; } = new List<string>();

        [OwnBehaviour] public static string PropertyName(int id) => properties[id];

        [OwnBehaviour] public Shader() { }

        public bool isSupported { get; [OwnBehaviour] set; } = true;

        [OwnBehaviour] public static Dictionary<string, object> Globals { get; } = new Dictionary<string, object>();

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/Shader.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/Shader.cs")]
        public static Vector4 GetGlobalVector(string name) =>
            Globals.TryGetValue(name, out object value) ? (Vector4)value : default;

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/Shader.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/Shader.cs")]
        public static Vector4 GetGlobalVector(int nameID) => GetGlobalVector(PropertyName(nameID));

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/Shader.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/Shader.cs")]
        public static Matrix4x4[] GetGlobalMatrixArray(string name) =>
            Globals.TryGetValue(name, out object value) ? (Matrix4x4[])value : null;

        public static Shader Find(string name) => Known.TryGetValue(name, out Shader shader) ? shader : null;

        public static int PropertyToID(string name)
        {
            if (!properties.Contains(name)) properties.Add(name);
            return properties.IndexOf(name);
        }
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/Material.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/Material.bindings.cs")]
    public partial class Material : Object
    {
        public Material(Shader shader) { this.shader = shader; }

        public Shader shader { get; set; }

        public int FindPass(string passName) => shader.PassNames.IndexOf(passName);
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/MaterialPropertyBlock.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/MaterialPropertyBlock.bindings.cs")]
    public sealed partial class MaterialPropertyBlock
    {
    }
}

namespace UnityEngine.Rendering
{
    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/GlobalKeyword.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/GlobalKeyword.bindings.cs")]
    public readonly struct GlobalKeyword
    {
        public string name { get; }

        public GlobalKeyword(string name) { this.name = name; }

        public static GlobalKeyword Create(string name) => new GlobalKeyword(name);
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Shaders/LocalKeyword.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Shaders/LocalKeyword.bindings.cs")]
    public readonly struct LocalKeyword : IEquatable<LocalKeyword>
    {
        public string name { get; }

        public LocalKeyword(Shader shader, string name) { this.name = name; }

        public bool Equals(LocalKeyword rhs) => name == rhs.name;
    }
}
