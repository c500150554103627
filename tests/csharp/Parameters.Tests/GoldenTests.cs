namespace Penumbra.Tests;

/// <summary>
/// Compares every figure of the C# mathematics with the C++ one's, from the same floats: within 1 ULP, and within 2
/// where a tangent takes part, since those are the C libraries' own.
/// </summary>
public class GoldenTests
{
    private const double Product = 1;
    private const double Tangent = 2;

    private static void Check(GoldenRecord record, string figure, float actual, float expected, double limit)
    {
        var distance = Ulp.Distance(actual, expected);
        if (distance <= limit) return;
        Assert.Fail($"{record.Label}: {figure} is {actual:R}, not {expected:R}: {distance} ULP, more than {limit}");
    }

    private static void Check(GoldenRecord record, string figure, float actual, double limit) =>
        Check(record, figure, actual, record.Float(figure), limit);

    private static void Check(GoldenRecord record, string figure, Vector4 actual, double limit) =>
        Check(record, figure, actual, record.Vector(figure), limit);

    private static void Check(GoldenRecord record, string figure, Vector4 actual, Vector4 expected, double limit)
    {
        Check(record, figure + ".x", actual.x, expected.x, limit);
        Check(record, figure + ".y", actual.y, expected.y, limit);
        Check(record, figure + ".z", actual.z, expected.z, limit);
        Check(record, figure + ".w", actual.w, expected.w, limit);
    }

    // A file that lost its records must not pass for agreement.
    private static void ForEach(string section, int atLeast, Action<GoldenRecord> check)
    {
        var records = GoldenRecord.Of(section).ToList();
        Assert.That(records.Count, Is.GreaterThanOrEqualTo(atLeast), section);
        records.ForEach(check);
    }

    [Test]
    public void AnglesAndTheirTangents() => ForEach("angles", 44, record =>
    {
        Check(record, "tan_half", AngularDiameter.TanHalf(record.Float("degrees")), Tangent);
        Check(record, "degrees_back", AngularDiameter.FromTanHalf(record.Float("tan_half")), Tangent);
    });

    [Test]
    public void AtlasLayouts() => ForEach("atlases", 28, record =>
    {
        var layout = record.Layout;
        Assert.That(layout.Width, Is.EqualTo(record.Int("width")), record.Label);
        Assert.That(layout.Height, Is.EqualTo(record.Int("height")), record.Label);
        Assert.That(layout.TileResolution, Is.EqualTo(record.Int("tile_resolution")), record.Label);
        Assert.That(record.Length("tiles"), Is.EqualTo(layout.Cascades), record.Label);
        Check(record, "texel_size", layout.TexelSize, Product);
        for (var i = 0; i < layout.Cascades; ++i)
        {
            Check(record, "tiles", layout.Tile(i), record.Vector("tiles", i), Product);
        }
    });

    [Test]
    public void ScalesOfCascades() => ForEach("cascades", 46, record =>
    {
        var scales = new CascadeScales(record.Matrix("world_to_shadow"), record.Layout, record.Float("degrees"));
        Assert.That(scales.IsMapped, record.Label);
        Check(record, "uv_per_metre", scales.UvPerMetre, Product);
        Check(record, "depth_per_metre", scales.DepthPerMetre, Product);
        Check(record, "depth_to_radial", scales.DepthToRadial, Tangent);
        Check(record, "radial_to_depth", scales.RadialToDepth, Tangent);
        Check(record, "depth_to_radial_hdrp", scales.DepthToRadialHdrp, Tangent);
        Check(record, "texel_size_metres", scales.TexelSizeMetres, Product);
        Check(record, "max_penumbra_texels", scales.MaxPenumbraTexels, Tangent);
    });

    [Test]
    public void BiasOfCascades() => ForEach("cascades", 46, record =>
    {
        var scales = new CascadeScales(record.Matrix("world_to_shadow"), record.Layout, record.Float("degrees"));
        var bias = ShadowBias.OfCascade(scales, record.Float("depth_bias"), record.Float("normal_bias"), record.Kernel);
        Check(record, "bias_depth", bias.x, Product);
        Check(record, "bias_normal", bias.y, Product);
    });

    [Test]
    public void BiasOfProjections() => ForEach("projections", 32, record =>
    {
        var projection = Matrix4x4.identity;
        projection.m00 = record.Float("m00");
        var bias = ShadowBias.OfProjection(projection, record.Int("tile_resolution"), record.Float("depth_bias"),
                                           record.Float("normal_bias"), record.Kernel);
        Check(record, "bias_depth", bias.x, Product);
        Check(record, "bias_normal", bias.y, Product);
    });

    [Test]
    public void HdrpVectorsOfCascades() => ForEach("cascades", 46, record =>
    {
        var scales = new CascadeScales(record.Matrix("world_to_shadow"), record.Layout, record.Float("degrees"));
        var hdrp = new HdrpShadowParameters(scales, record.Parameters);
        Check(record, "hdrp_params0", hdrp.Params0, Tangent);
        Check(record, "hdrp_params1", hdrp.Params1, Tangent);
    });

    [Test]
    public void UniformsOfParameters() => ForEach("uniforms", 38, record =>
    {
        var uniforms = new ShadowUniforms(record.Parameters, record.Layout, record.Int("frame"));
        Check(record, "atlas_texel_size", uniforms.MainLightAtlasTexelSize, Product);
        Check(record, "main_light_params", uniforms.MainLightParams, Tangent);
        Check(record, "hdrp_search_tan_half", uniforms.PcssHdrp.searchTanHalf, Tangent);
        Check(record, "hdrp_min_filter_tan_half", uniforms.PcssHdrp.minFilterTanHalf, Tangent);
    });

    [Test]
    public void ScreenToWorldOfCameras() => ForEach("cameras", 46, record =>
    {
        var conventions = new ScreenConventions(record.Bool("uv_starts_at_top"), record.Bool("depth_is_zero_to_one"));
        Assert.That(ScreenToWorld.TryGet(record.Matrix("view"), record.Matrix("gpu_projection"), conventions,
                                         out var actual), record.Label);
        var expected = record.Matrix("screen_to_world");
        for (var row = 0; row < 4; ++row) CheckRow(record, row, actual.GetRow(row), expected.GetRow(row));
    });

    private static void CheckRow(GoldenRecord record, int row, Vector4 actual, Vector4 expected)
    {
        var a = new[] { actual.x, actual.y, actual.z, actual.w };
        var e = new[] { expected.x, expected.y, expected.z, expected.w };
        var largest = e.Max(Math.Abs);
        for (var column = 0; column < 4; ++column)
        {
            var distance = Ulp.InRow(a[column], e[column], largest);
            Assert.That(distance, Is.LessThanOrEqualTo(Product),
                        $"{record.Label}: row {row}, column {column} is {a[column]:R}, not {e[column]:R}");
        }
    }
}
