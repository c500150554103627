using UnityEngine.Rendering;

namespace UnityEngine
{
    public enum CameraClearFlags { Skybox = 1, Color = 2, SolidColor = 2, Depth = 3, Nothing = 4 }

    public enum LightType { Spot = 0, Directional = 1, Point = 2 }

    public sealed partial class Camera
    {
        public float fieldOfView { get; set; } = 60.0f;
        public float nearClipPlane { get; set; } = 0.3f;
        public float farClipPlane { get; set; } = 1000.0f;
        public CameraType cameraType { get; set; } = CameraType.Game;
        public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;
        public Color backgroundColor { get; set; }

        public bool TryGetCullingParameters(out ScriptableCullingParameters cullingParameters)
        {
            cullingParameters = default;
            return true;
        }
    }

    public sealed partial class Light
    {
        public LightType type { get; set; }
        public Color color { get; set; } = Color.white;
        public float intensity { get; set; } = 1.0f;
        public float shadowNearPlane { get; set; } = 0.2f;
    }

    public sealed partial class Shader
    {
        public static void SetGlobalVector(int nameID, Vector4 value) => Globals[PropertyName(nameID)] = value;

        public static void SetGlobalVectorArray(int nameID, Vector4[] values) => Globals[PropertyName(nameID)] = values;

        public static void SetGlobalTexture(int nameID, Texture value) => Globals[PropertyName(nameID)] = value;
    }
}

namespace UnityEngine.Rendering.Universal
{
    public partial class UniversalRenderPipelineAsset
    {
        public int shadowCascadeCount { get; set; } = 1;

        protected override RenderPipeline CreatePipeline() => null;
    }
}

namespace UnityEditor
{
    public partial class Undo
    {
        public static void RegisterCreatedObjectUndo(UnityEngine.Object objectToUndo, string name) { }
    }
}
