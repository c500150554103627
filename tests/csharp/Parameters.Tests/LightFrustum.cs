namespace Penumbra.Tests;

/// <summary>
/// A directional light's cascade built from metres, by the rules of URP's ShadowUtils: the light looks along
/// (0, -sin, cos) of its elevation, its frustum is `Width` metres wide and `Range` deep.
/// </summary>
internal sealed class LightFrustum
{
    public double Width = 20.0;
    public double Range = 80.0;
    public double Elevation = 0.6;
    public bool ReversedZ = true;
    public AtlasLayout Layout = new AtlasLayout(2048, 4);
    public int Cascade = 3;

    /// <summary>The entry m00 of the light's projection, and m22 of the device's, whose depth is 0 to 1.</summary>
    public double M00 => 2.0 / Width;
    public double DeviceM22 => (ReversedZ ? 1.0 : -1.0) / Range;

    public Matrix4x4 WorldToShadow
    {
        get
        {
            var tile = Layout.Tile(Cascade);
            double sin = Math.Sin(Elevation), cos = Math.Cos(Elevation);
            double u = tile.z / Width, v = tile.w / Width, d = (ReversedZ ? -1.0 : 1.0) / Range;
            var m = Matrix4x4.identity;
            m.m00 = (float)u;
            m.m03 = (float)(tile.x + 0.5 * tile.z);
            m.m11 = (float)(v * cos);
            m.m12 = (float)(v * sin);
            m.m13 = (float)(tile.y + 0.5 * tile.w);
            m.m20 = 0.0f;
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
