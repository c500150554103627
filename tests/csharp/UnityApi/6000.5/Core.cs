namespace UnityEngine.Rendering.RenderGraphModule;

public enum TextureUVOrigin { BottomLeft = 0, TopLeft = 1 }

public partial struct RasterGraphContext
{
    [OwnBehaviour] public static TextureUVOrigin BackBuffer { get; set; }

    public TextureUVOrigin GetTextureUVOrigin(in TextureHandle textureHandle) =>
        textureHandle.Handle.What == "back buffer" ? BackBuffer : TextureUVOrigin.BottomLeft;
}
