using System;
using System.Collections.Generic;
using Penumbra.UnityApi;

namespace UnityEngine.Rendering
{
    /// <summary>Writes down what it is told; a context plays it into FakeDevice.</summary>
    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.bindings.cs")]
    public partial class CommandBuffer : IDisposable
    {
        private readonly List<Action<FakeDevice>> commands = new List<Action<FakeDevice>>();

        [OwnBehaviour] public IReadOnlyList<Action<FakeDevice>> Commands => commands;

        /// <summary>The command of this number, of all buffers together, throws; -1: none does.</summary>
        [OwnBehaviour] public static int FailAt { get; set; } = -1;

        /// <summary>Writes nothing down, so that what a caller allocates can be counted.</summary>
        [OwnBehaviour] public static bool Silent { get; set; }

        [OwnBehaviour]
        public void Add(Action<FakeDevice> command)
        {
            if (FailAt >= 0 && FailAt-- == 0) throw new InvalidOperationException("the camera fails here");
            commands.Add(command);
        }

        public void Clear() => commands.Clear();

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void Dispose() { }

        public void SetKeyword(in GlobalKeyword keyword, bool value)
        {
            if (!Silent) Recorded.Keyword(this, keyword.name, value);
        }

        public void SetKeyword(Material material, in LocalKeyword keyword, bool value)
        {
            if (!Silent) Recorded.MaterialKeyword(this, keyword.name, value);
        }

        public void SetGlobalVector(int nameID, Vector4 value)
        {
            if (!Silent) Recorded.Uniform(this, nameID, value);
        }

        public void SetGlobalMatrixArray(int nameID, Matrix4x4[] values)
        {
            if (!Silent) Recorded.Uniform(this, nameID, values.Clone());
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void SetGlobalTexture(int nameID, RenderTargetIdentifier value)
        {
            if (!Silent) Recorded.Texture(this, nameID, value.What);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
                                   int vertexCount, int instanceCount, MaterialPropertyBlock properties)
        {
            if (!Silent) Recorded.Draw(this, material.shader.PassNames[shaderPass], vertexCount * instanceCount);
        }
    }

    /// <summary>The commands, apart so that a silent buffer makes no closures.</summary>
    [OwnBehaviour]
    public static class Recorded
    {
        public static void Keyword(CommandBuffer buffer, string name, bool value) =>
            buffer.Add(device => device.SetKeyword(name, value));

        public static void MaterialKeyword(CommandBuffer buffer, string name, bool value) =>
            buffer.Add(device => device.SetMaterialKeyword(name, value));

        public static void Uniform(CommandBuffer buffer, int id, object value) =>
            buffer.Add(device => device.Uniforms[Shader.PropertyName(id)] = value);

        public static void Texture(CommandBuffer buffer, int id, string texture) =>
            buffer.Add(device => device.Textures[Shader.PropertyName(id)] = texture);

        public static void Draw(CommandBuffer buffer, string pass, int vertices) =>
            buffer.Add(device => device.Draw(pass, vertices));

        public static void Target(CommandBuffer buffer, string target) =>
            buffer.Add(device => device.Target = target);
    }
}
