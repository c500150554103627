namespace UnityEngine
{
    [Flags]
    public enum CameraType { Game = 1, SceneView = 2, Preview = 4, VR = 8, Reflection = 16 }

    public enum LightShadows { None = 0, Hard = 1, Soft = 2 }

    public enum MeshTopology { Triangles = 0 }

    public enum FilterMode { Point = 0, Bilinear = 1 }

    public enum TextureWrapMode { Repeat = 0, Clamp = 1 }

    public enum CubemapFace { Unknown = -1 }

    public enum RenderTextureFormat { Depth = 1, Shadowmap = 3 }
}

namespace UnityEngine.Rendering
{
    public enum RenderBufferLoadAction { Load = 0, Clear = 1, DontCare = 2 }

    public enum RenderBufferStoreAction { Store = 0, DontCare = 3 }

    public enum TextureDimension { Tex2D = 2, Tex3D = 3, Tex2DArray = 5 }

    [System.Flags]
    public enum CopyTextureSupport { None = 0, Basic = 1 << 0 }
}

namespace UnityEngine
{
    public enum VRTextureUsage { None, OneEye, TwoEyes }
}

namespace UnityEngine.Experimental.Rendering
{
    [System.Flags]
    public enum TextureCreationFlags { None = 0 }

    public enum GraphicsFormat
    {
        None = 0, R8_UNorm = 5, R8G8_UNorm = 6, R16_UNorm = 21, R16G16_UNorm = 22, R16G16B16A16_UNorm = 24,
        R32_UInt = 37, R32G32B32A32_UInt = 40, R16_SFloat = 45, R16G16_SFloat = 46, R16G16B16A16_SFloat = 48,
        R32_SFloat = 49, R32G32_SFloat = 50, R32G32B32A32_SFloat = 52, B8G8R8A8_UNorm = 59, D16_UNorm = 90,
        D32_SFloat = 93,
    }
}
