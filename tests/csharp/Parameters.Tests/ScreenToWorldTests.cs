namespace Penumbra.Tests;

/// <summary>
/// Matrices without an answer; tests/golden/parameters.json has the others, and DrawTests every convention.
/// </summary>
public class ScreenToWorldTests
{
    // The view turns and moves, and the projection is off-centre, to reversed depth 0 .. 1.
    private static readonly Matrix4x4 View = Rows(new Vector4(0.8f, 0, -0.6f, 3), new Vector4(0, 1, 0, -2),
                                                  new Vector4(0.6f, 0, 0.8f, -5), new Vector4(0, 0, 0, 1));

    private static Matrix4x4 Projection(float near, float far) =>
        Rows(new Vector4(0.9f, 0, 0.2f, 0), new Vector4(0, 1.6f, -0.1f, 0),
             new Vector4(0, 0, near / (far - near), near * far / (far - near)), new Vector4(0, 0, -1, 0));

    private static Matrix4x4 Rows(Vector4 x, Vector4 y, Vector4 z, Vector4 w) =>
        Adversary.Build((row, column) => Adversary.Entry(new Matrix4x4(x, y, z, w), column, row));

    [Test]
    public void ASingularMatrixHasNoAnswerAndGivesTheIdentity()
    {
        var good = Projection(0.3f, 60.0f);
        foreach (var singular in Adversary.Singular(good)) AssertNoAnswer(View, singular);
        foreach (var singular in Adversary.Singular(View)) AssertNoAnswer(singular, good);
    }

    // Row 3 is exactly row 0 plus row 2, of integers whose minors fill a double: the determinant comes out as
    // rounding noise, not as 0.
    [Test]
    public void ASingularMatrixIsSeenThroughTheRounding()
    {
        var random = new Random(11);
        for (var i = 0; i < 500; ++i)
        {
            var rows = new float[12];
            for (var entry = 0; entry < rows.Length; ++entry) rows[entry] = random.Next(-(1 << 20), 1 << 20);
            AssertNoAnswer(View, Adversary.Build((row, column) =>
                row < 3 ? rows[4 * row + column] : rows[column] + rows[8 + column]));
        }
    }

    private static void AssertNoAnswer(Matrix4x4 view, Matrix4x4 projection)
    {
        Assert.That(ScreenToWorld.TryGet(view, projection, ScreenConventions.Direct3D, out var matrix), Is.False);
        Assert.That(matrix, Is.EqualTo(Matrix4x4.identity));
    }

    [Test]
    public void TheMatrixIsFiniteWhateverTheInputs()
    {
        var answers = 0;
        var good = Projection(0.3f, 60.0f);
        foreach (var conventions in new[] { ScreenConventions.Direct3D, ScreenConventions.OpenGL })
        {
            foreach (var matrix in Adversary.Matrices(good))
            {
                answers += ScreenToWorld.TryGet(View, matrix, conventions, out var asProjection) ? 1 : 0;
                answers += ScreenToWorld.TryGet(matrix, good, conventions, out var asView) ? 1 : 0;
                ScreenToWorld.TryGet(matrix, matrix, conventions, out var asBoth);
                Assert.That(Adversary.IsFinite(asProjection) && Adversary.IsFinite(asView));
                Assert.That(Adversary.IsFinite(asBoth));
            }
        }
        Assert.That(answers, Is.GreaterThan(100), "only a test if some have an answer");
    }
}
