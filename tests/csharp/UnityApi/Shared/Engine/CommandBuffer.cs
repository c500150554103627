namespace UnityEngine.Rendering;

/// <summary>Records what it is told; a context plays it into FakeDevice.</summary>
public partial class CommandBuffer : IDisposable
{
    private readonly List<Action<FakeDevice>> commands = new();

    [OwnBehaviour] public IReadOnlyList<Action<FakeDevice>> Commands => commands;

    /// <summary>The number of the command, counted over all buffers together, that throws; -1 for none.</summary>
    [OwnBehaviour] public static int FailAt { get; set; } = -1;

    /// <summary>Whether nothing is recorded, so that what a caller allocates can be counted.</summary>
    [OwnBehaviour] public static bool Silent { get; set; }

    /// <summary>Records a command with what it is told; a silent buffer makes no closure.</summary>
    [OwnBehaviour]
    public void Record<T>(Action<FakeDevice, T> command, T told)
    {
        if (!Silent) Keep(command, told);
    }

    private void Keep<T>(Action<FakeDevice, T> command, T told)
    {
        if (FailAt >= 0 && FailAt-- == 0) throw new InvalidOperationException("the camera fails here");
        commands.Add(device => command(device, told));
    }

    public void Clear() => commands.Clear();

    public void Dispose() { }

    public void SetKeyword(in GlobalKeyword keyword, bool value) =>
        Record(static (device, told) => device.SetKeyword(told.name, told.value), (keyword.name, value));

    public void SetKeyword(Material material, in LocalKeyword keyword, bool value) =>
        Record(static (device, told) => device.SetMaterialKeyword(told.name, told.value), (keyword.name, value));

    public void SetKeyword(ComputeShader computeShader, in LocalKeyword keyword, bool value) =>
        Record(static (device, told) => device.SetMaterialKeyword(told.name, told.value), (keyword.name, value));

    private void Uniform<T>(int id, T value) =>
        Record(static (device, told) => device.Uniforms[Shader.PropertyName(told.id)] = told.value, (id, value));

    private void Texture(int id, string texture) =>
        Record(static (device, told) => device.Textures[Shader.PropertyName(told.id)] = told.texture, (id, texture));

    [OwnBehaviour]
    public void Target(string target, int mip = 0, int slice = -1,
                       RenderBufferLoadAction load = RenderBufferLoadAction.Load) =>
        Record(static (device, told) =>
                   device.SetTarget(told.target + (told.mip > 0 ? " mip " + told.mip : "") +
                                    (told.slice >= 0 ? " slice " + told.slice : ""), told.load),
               (target, mip, slice, load));

    public void SetGlobalInteger(int nameID, int value) => Uniform(nameID, value);
    public void SetGlobalVector(int nameID, Vector4 value) => Uniform(nameID, value);

    public void SetGlobalMatrixArray(int nameID, Matrix4x4[] values) => Uniform(nameID, Silent ? null : values.Clone());

    public void SetGlobalTexture(int nameID, RenderTargetIdentifier value) => Texture(nameID, value.What);

    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
                               int vertexCount, int instanceCount, MaterialPropertyBlock properties) =>
        Record(static (device, told) => device.Draw(told.pass, told.vertices),
               (pass: material.shader.PassNames[shaderPass], vertices: vertexCount * instanceCount));

    public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
        Target(rt.What, mipLevel, depthSlice);

    public void SetViewport(Rect pixelRect) => Record(static (device, rect) => device.SetViewport(rect), pixelRect);

    public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth, int mipLevel,
                                CubemapFace cubemapFace, int depthSlice)
    {
        if (Silent) return;
        string all = "";
        foreach (RenderTargetIdentifier color in colors) all += (all == "" ? "" : " + ") + color.What;
        if (!depth.Equals(colors[0])) all += " over " + depth.What;
        Target(all, mipLevel, depthSlice);
    }

    public void CopyTexture(RenderTargetIdentifier src, int srcElement, int srcMip, int srcX, int srcY, int srcWidth,
                            int srcHeight, RenderTargetIdentifier dst, int dstElement, int dstMip, int dstX, int dstY)
    {
        if (!Silent)
            Record(static (device, what) => device.Copies.Add(what),
                   $"{src.What} slice {srcElement} mip {srcMip} {srcX} {srcY} {srcWidth}x{srcHeight} to {dst.What} " +
                   $"slice {dstElement} mip {dstMip} {dstX} {dstY}");
    }

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID,
                                       RenderTargetIdentifier rt) => Texture(nameID, rt.What);

    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX, int threadGroupsY,
                                int threadGroupsZ) =>
        Record(static (device, told) => device.Dispatch(told.Name, told.x + " " + told.y + " " + told.z),
               (computeShader.Kernels[kernelIndex].Name, x: threadGroupsX, y: threadGroupsY, z: threadGroupsZ));
}
