using System;
using System.Collections.Generic;
using Penumbra.UnityApi;

namespace UnityEngine.Rendering
{
    /// <summary>Records what it is told; a context plays it into FakeDevice.</summary>
    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.bindings.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.bindings.cs")]
    public partial class CommandBuffer : IDisposable
    {
        private readonly List<Action<FakeDevice>> commands = new List<Action<FakeDevice>>();

        [OwnBehaviour] public IReadOnlyList<Action<FakeDevice>> Commands => commands;

        /// <summary>The number of the command, counted over all buffers together, that throws; -1 for none.</summary>
        [OwnBehaviour] public static int FailAt { get; set; } = -1;

        /// <summary>Whether nothing is recorded, so that what a caller allocates can be counted.</summary>
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

        public void SetKeyword(ComputeShader computeShader, in LocalKeyword keyword, bool value)
        {
            if (!Silent) Recorded.MaterialKeyword(this, keyword.name, value);
        }

        public void SetGlobalInteger(int nameID, int value)
        {
            if (!Silent) Recorded.Uniform(this, nameID, value);
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

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void SetGlobalBuffer(int nameID, GraphicsBuffer value)
        {
            if (!Silent) Recorded.Texture(this, nameID, value.What);
        }

        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace, int depthSlice)
        {
            if (!Silent) Recorded.Target(this, rt.What, mipLevel, depthSlice);
        }

        public void SetViewport(Rect pixelRect)
        {
            if (!Silent) Recorded.Viewport(this, pixelRect);
        }

        public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth, int mipLevel,
                                    CubemapFace cubemapFace, int depthSlice)
        {
            if (!Silent) Recorded.Targets(this, colors, depth, mipLevel, depthSlice);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void CopyTexture(RenderTargetIdentifier src, int srcElement, int srcMip, int srcX, int srcY,
                                int srcWidth, int srcHeight, RenderTargetIdentifier dst, int dstElement, int dstMip,
                                int dstX, int dstY)
        {
            if (!Silent)
                Recorded.Copy(this, src.What + " slice " + srcElement + " mip " + srcMip + " " + srcX + " " + srcY + " " +
                                    srcWidth + "x" + srcHeight + " to " + dst.What + " slice " + dstElement + " mip " +
                                    dstMip + " " + dstX + " " + dstY);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID,
                                           RenderTargetIdentifier rt)
        {
            if (!Silent) Recorded.Texture(this, nameID, rt.What);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID,
                                           RenderTargetIdentifier rt, int mipLevel)
        {
            if (!Silent) Recorded.Texture(this, nameID, rt.What + " mip " + mipLevel);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID,
                                          GraphicsBuffer buffer)
        {
            if (!Silent) Recorded.Texture(this, nameID, buffer.What);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX,
                                    int threadGroupsY, int threadGroupsZ)
        {
            if (!Silent)
                Recorded.Dispatch(this, computeShader.Kernels[kernelIndex].Name,
                                  threadGroupsX + " " + threadGroupsY + " " + threadGroupsZ);
        }

        [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        [ReadFrom(At.Unity6, "engine", "Runtime/Export/Graphics/RenderingCommandBuffer.cs")]
        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, GraphicsBuffer indirectBuffer,
                                    uint argsOffset)
        {
            if (!Silent)
                Recorded.Dispatch(this, computeShader.Kernels[kernelIndex].Name,
                                  "as " + indirectBuffer.What + " at " + argsOffset);
        }
    }

    /// <summary>The commands stand apart so that a silent buffer makes no closures.</summary>
    [OwnBehaviour]
    public static class Recorded
    {
        public static void Keyword(CommandBuffer buffer, string name, bool value) =>
            buffer.Add(device => device.SetKeyword(name, value));

        public static void AsyncCompilation(CommandBuffer buffer, bool allow) =>
            buffer.Add(device => device.CompilesAsynchronously = allow);

        public static void MaterialKeyword(CommandBuffer buffer, string name, bool value) =>
            buffer.Add(device => device.SetMaterialKeyword(name, value));

        public static void Uniform(CommandBuffer buffer, int id, object value) =>
            buffer.Add(device => device.Uniforms[Shader.PropertyName(id)] = value);

        public static void Texture(CommandBuffer buffer, int id, string texture) =>
            buffer.Add(device => device.Textures[Shader.PropertyName(id)] = texture);

        public static void Draw(CommandBuffer buffer, string pass, int vertices) =>
            buffer.Add(device => device.Draw(pass, vertices));

        public static void Target(CommandBuffer buffer, string target, int mip = 0, int slice = -1,
                                  RenderBufferLoadAction load = RenderBufferLoadAction.Load) =>
            buffer.Add(device => device.SetTarget(target + (mip > 0 ? " mip " + mip : "") +
                                                  (slice >= 0 ? " slice " + slice : ""), load));

        public static void Targets(CommandBuffer buffer, RenderTargetIdentifier[] colors,
                                   RenderTargetIdentifier depth, int mip, int slice)
        {
            string all = "";
            foreach (RenderTargetIdentifier color in colors) all += (all == "" ? "" : " + ") + color.What;
            if (!depth.Equals(colors[0])) all += " over " + depth.What;
            Target(buffer, all, mip, slice);
        }

        public static void Clear(CommandBuffer buffer, Color colour) => buffer.Add(device => device.Clear(colour));

        /// <summary>Clears as part of drawing is told to the device, not as a draw.</summary>
        public static void Clear(CommandBuffer buffer, string what) =>
            buffer.Add(device => device.Uniforms["cleared"] = what);

        public static void View(CommandBuffer buffer, Matrix4x4 view, Matrix4x4 projection) =>
            buffer.Add(device => device.Uniforms["view"] = (view, projection));

        public static void Viewport(CommandBuffer buffer, Rect rect) =>
            buffer.Add(device => device.SetViewport(rect));

        public static void Copy(CommandBuffer buffer, string what) => buffer.Add(device => device.Copies.Add(what));

        public static void Dispatch(CommandBuffer buffer, string kernel, string groups) =>
            buffer.Add(device => device.Dispatch(kernel, groups));
    }
}
