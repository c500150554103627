namespace Penumbra.Tests;

/// <summary>One camera and the light it sees, as far as shadows go.</summary>
internal sealed class FakeScene
{
    internal CameraType Camera = CameraType.Game;
    internal bool Supported = true;
    internal bool MainLight = true;

    /// <summary>The main light; null stands for one of no game object.</summary>
    internal Light Sun;
    internal LightShadows Shadows = LightShadows.Soft;
    internal float Distance = 50.0f;

    /// <summary>The direction in which the light shines.</summary>
    internal Vector3 Forward = new Vector3(0.6f, -0.8f, 0.0f);
    internal bool SoftShadows = true;

    /// <summary>The border of the last cascade, a share of the distance.</summary>
    internal float Border = 0.2f;
    internal bool Casters = true;
    internal int Cascades = 4;

    /// <summary>The cascade for which the engine finds no view of the light; -1 for none.</summary>
    internal int CascadeWithoutView = -1;
    internal bool SceneLightingOff, DepthOnly, Overlay;

    /// <summary>
    /// Whether the camera draws into the back buffer, without a texture of its own; only Unity 6 has this.
    /// </summary>
    internal bool ToBackBuffer;
    internal int Views = 0;
    internal int Width = 321;
    internal int Height = 181;
    internal bool DynamicResolution;
    internal Matrix4x4 Projection = Perspective(0.1f);

    /// <summary>Whether URP draws a shadow map.</summary>
    internal bool UrpDraws => HasShadows && HasMap;

    /// <summary>Whether URP binds an empty map.</summary>
    internal bool UrpHasNothingToDraw => HasShadows && !HasMap;

    private bool HasShadows => Supported && MainLight && Shadows != LightShadows.None && Distance > 0.0f && !SceneLightingOff;

    private bool HasMap => Casters && (CascadeWithoutView < 0 || CascadeWithoutView >= Cascades);

    /// <summary>The main light's baking; the asset supports mixed lighting.</summary>
    internal LightBakingOutput Baking;
    internal bool MixedLighting = true;

    private Camera camera;

    /// <summary>The camera, the same in every frame.</summary>
    internal Camera MakeCamera()
    {
        camera = camera ?? new Camera();
        camera.allowDynamicResolution = DynamicResolution;
        if (SceneLightingOff) CoreUtils.Unlit.Add(camera);
        return camera;
    }

    internal CullingResults Cull()
    {
        CullingResults.Missing.Clear();
        if (CascadeWithoutView >= 0) CullingResults.Missing.Add(CascadeWithoutView);
        return new CullingResults { HasCasters = Casters };
    }

    internal RenderTexture Texture() => DepthOnly ? new RenderTexture { format = RenderTextureFormat.Depth } : null;

    internal VisibleLight[] Lights()
    {
        if (!MainLight) return new VisibleLight[0];
        Light light = Sun ?? new Light();
        light.shadows = Shadows;
        light.shadowStrength = 0.75f;
        light.bakingOutput = Baking;
        light.transform.forward = Forward;
        return new[] { new VisibleLight { Source = light } };
    }

    internal RenderTextureDescriptor Target() => new RenderTextureDescriptor
    {
        width = Width, height = Height, msaaSamples = 4, volumeDepth = Math.Max(Views, 1),
        graphicsFormat = GraphicsFormat.B8G8R8A8_UNorm, useDynamicScale = DynamicResolution,
    };

    /// <summary>The place of the camera along the x axis, metres.</summary>
    internal float CameraX;

    internal Matrix4x4[] ViewMatrices() => new[] { View(CameraX), View(CameraX + 0.064f) };
    internal Matrix4x4[] Projections() => new[] { Projection, Perspective(-0.1f) };

    /// <summary>A perspective projection, off-centre by `shift` of its width, as an eye's is.</summary>
    internal static Matrix4x4 Perspective(float shift)
    {
        Matrix4x4 m = Matrix4x4.zero;
        m.m00 = 1.2f;
        m.m02 = shift;
        m.m11 = 1.7f;
        m.m22 = -(100.0f + 0.3f) / (100.0f - 0.3f);
        m.m23 = -2.0f * 100.0f * 0.3f / (100.0f - 0.3f);
        m.m32 = -1.0f;
        return m;
    }

    private static Matrix4x4 View(float right)
    {
        Matrix4x4 m = Matrix4x4.identity;
        m.m03 = -right;
        m.m13 = -1.7f;
        return m;
    }

    internal static IEnumerable<FakeScene> Every()
    {
        foreach (CameraType camera in Enum.GetValues(typeof(CameraType)))
            for (int cascades = 1; cascades <= 4; ++cascades)
                foreach (Action<FakeScene> change in Changes)
                {
                    var scene = new FakeScene { Camera = camera, Cascades = cascades };
                    change(scene);
                    yield return scene;
                }
    }

    private static readonly Action<FakeScene>[] Changes =
    {
        scene => { }, scene => scene.Supported = false, scene => scene.MainLight = false,
        scene => scene.Shadows = LightShadows.None, scene => scene.Distance = 0.0f,
        scene => scene.Casters = false, scene => scene.CascadeWithoutView = 0,
        scene => scene.CascadeWithoutView = 2, scene => scene.SceneLightingOff = true, scene => scene.DepthOnly = true,
        scene => scene.Views = 2, scene => scene.Projection = Matrix4x4.zero,
    };

    public override string ToString() =>
        $"{Camera}, {Cascades} cascades, supported {Supported}, light {MainLight} {Shadows}, {Distance} m, " +
        $"casters {Casters}, cascade without view {CascadeWithoutView}, lighting off {SceneLightingOff}, depth only {DepthOnly}, views {Views}, " +
        $"projection {Projection.m00}";
}

/// <summary>URP's keywords at the places of a camera's frame where receivers are drawn.</summary>
internal sealed class FrameKeywords
{
    internal string AtOpaques, AtTransparents, AtEnd;

    /// <summary>_MainLightShadowParams, if anything but URP has set it.</summary>
    internal Vector4? ReceiversAtOpaques;

    public override string ToString() => $"{AtOpaques} | {AtTransparents} | {AtEnd}";
}
