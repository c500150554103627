using System;

namespace Penumbra
{
    /// <summary>
    /// The six 2 x 2 minors of two columns, Rpq of rows p and q, each with the sum of its terms' magnitudes, Apq,
    /// which shows how many digits of Rpq cancelled.
    /// </summary>
    internal readonly struct DoubleMinors
    {
        public readonly double R01;
        public readonly double R02;
        public readonly double R03;
        public readonly double R12;
        public readonly double R13;
        public readonly double R23;
        public readonly double A01;
        public readonly double A02;
        public readonly double A03;
        public readonly double A12;
        public readonly double A13;
        public readonly double A23;

        public DoubleMinors(in DoubleColumn a, in DoubleColumn b)
        {
            R01 = Minor(a.X, a.Y, b.X, b.Y, out A01);
            R02 = Minor(a.X, a.Z, b.X, b.Z, out A02);
            R03 = Minor(a.X, a.W, b.X, b.W, out A03);
            R12 = Minor(a.Y, a.Z, b.Y, b.Z, out A12);
            R13 = Minor(a.Y, a.W, b.Y, b.W, out A13);
            R23 = Minor(a.Z, a.W, b.Z, b.W, out A23);
        }

        /// <summary>
        /// The vector perpendicular to a column and to both columns of the minors, scaled: the cross product of three
        /// vectors in four dimensions, which is a row of the inverse times the determinant.
        /// </summary>
        public DoubleColumn Complement(in DoubleColumn c, double scale) =>
            new DoubleColumn(scale * (c.Y * R23 - c.Z * R13 + c.W * R12), scale * (c.Z * R03 - c.X * R23 - c.W * R02),
                             scale * (c.X * R13 - c.Y * R03 + c.W * R01), scale * (c.Y * R02 - c.X * R12 - c.Z * R01));

        private static double Minor(double ap, double aq, double bp, double bq, out double magnitude)
        {
            magnitude = Math.Abs(ap * bq) + Math.Abs(aq * bp);
            return ap * bq - aq * bp;
        }
    }
}
