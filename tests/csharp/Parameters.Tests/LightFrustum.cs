namespace Penumbra.Tests;

/// <summary>
/// A directional light's cascade built from metres, by the rules of URP's ShadowUtils: the light looks along
/// (0, -sin, cos) of its elevation, its frustum is `Width` metres wide and `Range` deep.
/// </summary>
internal sealed class LightFrustum
{
    public const double Width = 20.0, Range = 80.0, Elevation = 0.6;
    public static readonly AtlasLayout Layout = new AtlasLayout(2048, 4);
    public int Cascade = 3;

    public Matrix4x4 WorldToShadow
    {
        get
        {
            var tile = Layout.Tile(Cascade);
            double sin = Math.Sin(Elevation), cos = Math.Cos(Elevation);
            double u = tile.z / Width, v = tile.w / Width, d = -1.0 / Range;
            var m = Matrix4x4.identity;
            m.m00 = (float)u;
            m.m03 = (float)(tile.x + 0.5 * tile.z);
            m.m11 = (float)(v * cos);
            m.m12 = (float)(v * sin);
            m.m13 = (float)(tile.y + 0.5 * tile.w);
            m.m21 = (float)(d * -sin);
            m.m22 = (float)(d * cos);
            m.m23 = 0.5f;
            return m;
        }
    }

    public CascadeScales Scales(float degrees) => new CascadeScales(WorldToShadow, Layout, degrees);

    /// <summary>URP's matrix of the entries of _MainLightWorldToShadow that a frame does not use.</summary>
    public static Matrix4x4 NoOp(bool reversedZ)
    {
        Matrix4x4 matrix = default;
        matrix.m22 = reversedZ ? 1.0f : 0.0f;
        return matrix;
    }
}
