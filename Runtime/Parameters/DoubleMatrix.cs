using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// A column-major 4 x 4 matrix in double, for inverses that would lose their precision in float.
    /// <para>With float entries no intermediate result overflows: a product of four is at most 1e154.</para>
    /// </summary>
    internal struct DoubleMatrix
    {
        // A determinant whose magnitude is below this many of its own rounding errors counts as 0.
        private const double SingularRoundings = 64.0 / (1L << 53);

        public DoubleColumn Column0;
        public DoubleColumn Column1;
        public DoubleColumn Column2;
        public DoubleColumn Column3;

        public static DoubleMatrix From(in Matrix4x4 m)
        {
            DoubleMatrix matrix;
            matrix.Column0 = new DoubleColumn(m.m00, m.m10, m.m20, m.m30);
            matrix.Column1 = new DoubleColumn(m.m01, m.m11, m.m21, m.m31);
            matrix.Column2 = new DoubleColumn(m.m02, m.m12, m.m22, m.m32);
            matrix.Column3 = new DoubleColumn(m.m03, m.m13, m.m23, m.m33);
            return matrix;
        }

        public static DoubleMatrix Product(in DoubleMatrix a, in DoubleMatrix b)
        {
            DoubleMatrix product;
            product.Column0 = Transform(a, b.Column0);
            product.Column1 = Transform(a, b.Column1);
            product.Column2 = Transform(a, b.Column2);
            product.Column3 = Transform(a, b.Column3);
            return product;
        }

        /// <summary>
        /// Inverts the matrix by Laplace's expansion over the first two columns: with pq the 2 x 2 minor of rows p and
        /// q in columns 0, 1 and PQ the same in columns 2, 3, the determinant is 01 23' - 02 13' + 03 12' + 12 03' - 13
        /// 02' + 23 01'. The result is false for a matrix that is singular within double precision, and for one that is
        /// not finite.
        /// </summary>
        public bool TryInvert(out DoubleMatrix inverse)
        {
            var left = new DoubleMinors(Column0, Column1);
            var right = new DoubleMinors(Column2, Column3);
            var determinant = left.R01 * right.R23 - left.R02 * right.R13 + left.R03 * right.R12 +
                              left.R12 * right.R03 - left.R13 * right.R02 + left.R23 * right.R01;
            var magnitude = left.A01 * right.A23 + left.A02 * right.A13 + left.A03 * right.A12 +
                            left.A12 * right.A03 + left.A13 * right.A02 + left.A23 * right.A01;
            // The condition is written so that NaN counts as singular, too.
            if (!(Math.Abs(determinant) > SingularRoundings * magnitude && magnitude < double.PositiveInfinity))
            {
                inverse = default;
                return false;
            }
            var scale = 1.0 / determinant;
            inverse = FromRows(right.Complement(Column1, scale), right.Complement(Column0, -scale),
                               left.Complement(Column3, scale), left.Complement(Column2, -scale));
            return true;
        }

        /// <summary>Rounds the matrix to floats; false, with the identity, if an entry does not fit a float.</summary>
        public bool TryRound(out Matrix4x4 matrix)
        {
            var fits = Fits(Column0) && Fits(Column1) && Fits(Column2) && Fits(Column3);
            matrix = fits ? new Matrix4x4(Round(Column0), Round(Column1), Round(Column2), Round(Column3))
                          : Matrix4x4.identity;
            return fits;
        }

        private static DoubleColumn Transform(in DoubleMatrix m, in DoubleColumn v) =>
            v.X * m.Column0 + v.Y * m.Column1 + v.Z * m.Column2 + v.W * m.Column3;

        private static DoubleMatrix FromRows(in DoubleColumn x, in DoubleColumn y, in DoubleColumn z, in DoubleColumn w)
        {
            DoubleMatrix matrix;
            matrix.Column0 = new DoubleColumn(x.X, y.X, z.X, w.X);
            matrix.Column1 = new DoubleColumn(x.Y, y.Y, z.Y, w.Y);
            matrix.Column2 = new DoubleColumn(x.Z, y.Z, z.Z, w.Z);
            matrix.Column3 = new DoubleColumn(x.W, y.W, z.W, w.W);
            return matrix;
        }

        private static bool Fits(in DoubleColumn c) =>
            Bounded.FitsFloat(c.X) && Bounded.FitsFloat(c.Y) && Bounded.FitsFloat(c.Z) && Bounded.FitsFloat(c.W);

        private static Vector4 Round(in DoubleColumn c) => new Vector4((float)c.X, (float)c.Y, (float)c.Z, (float)c.W);
    }
}
