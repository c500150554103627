namespace Penumbra.Tests;

/// <summary>Code that runs every frame and camera leaves nothing for the garbage collector.</summary>
public class AllocationTests
{
    private const int Calls = 10000;

    private static long BytesOf(Action<int> frame)
    {
        for (var i = 0; i < 100; ++i) frame(i);
        return Allocations.Of(() =>
        {
            for (var i = 0; i < Calls; ++i) frame(i);
        });
    }

    [Test]
    public void TheCounterSeesAnAllocation()
    {
        object kept = null;
        Assert.That(BytesOf(i => kept = new object()), Is.GreaterThanOrEqualTo(Calls));
        Assert.That(kept, Is.Not.Null);
    }

    [Test]
    public void AFramesWorkAllocatesNothing()
    {
        var matrices = new Matrix4x4[5];
        for (var i = 0; i < 4; ++i) matrices[i] = new LightFrustum { Cascade = i }.WorldToShadow;
        matrices[4] = LightFrustum.NoOp(true);
        var view = Matrix4x4.identity;
        var projection = new LightFrustum().WorldToShadow;
        var singular = LightFrustum.NoOp(true);
        var sum = 0.0;
        var bytes = BytesOf(frame =>
        {
            var parameters = frame % 2 == 0 ? SoftShadowParameters.Default : SoftShadowParameters.HdrpDefault;
            var layout = new AtlasLayout(2048, 1 + frame % 4);
            var uniforms = new ShadowUniforms(parameters, layout, frame);
            sum += uniforms.MainLightParams.y + layout.TexelSize.x;
            for (var i = 0; i < matrices.Length; ++i) sum += Figures(matrices[i], layout, parameters, i);
            ScreenToWorld.TryGet(view, projection, ScreenConventions.Direct3D, out var found);
            ScreenToWorld.TryGet(view, singular, ScreenConventions.OpenGL, out var notFound);
            sum += found.m00 + notFound.m11 + AngularDiameter.FromTanHalf(uniforms.MainLightParams.y);
            sum += AngularDiameter.Problem(parameters.AngularDiameterDegrees) == null ? 0.0 : 1.0;
        });
        Assert.That(bytes, Is.Zero);
        Assert.That(sum, Is.GreaterThan(0.0));
    }

    private static double Figures(in Matrix4x4 matrix, in AtlasLayout layout, in SoftShadowParameters parameters,
                                  int cascade)
    {
        var scales = new CascadeScales(matrix, layout, parameters.AngularDiameterDegrees);
        var hdrp = new HdrpShadowParameters(scales, parameters);
        var bias = ShadowBias.OfCascade(scales, 1.0f, 1.0f, SoftShadowKernel.Medium);
        var other = ShadowBias.OfProjection(matrix, layout.TileResolution, 1.0f, 1.0f, SoftShadowKernel.High);
        return layout.Tile(cascade).x + scales.UvPerMetre + scales.DepthPerMetre + scales.DepthToRadial +
               scales.RadialToDepth + scales.DepthToRadialHdrp + scales.TexelSizeMetres +
               scales.MaxPenumbraTexels + hdrp.Params0.x + hdrp.Params1.y + bias.x + other.y;
    }
}
