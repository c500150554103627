namespace Penumbra
{
    /// <summary>One column of a DoubleMatrix.</summary>
    internal struct DoubleColumn
    {
        public double X;
        public double Y;
        public double Z;
        public double W;

        public DoubleColumn(double x, double y, double z, double w)
        {
            X = x;
            Y = y;
            Z = z;
            W = w;
        }

        public static DoubleColumn operator *(double scale, in DoubleColumn column) =>
            new DoubleColumn(scale * column.X, scale * column.Y, scale * column.Z, scale * column.W);

        public static DoubleColumn operator +(in DoubleColumn a, in DoubleColumn b) =>
            new DoubleColumn(a.X + b.X, a.Y + b.Y, a.Z + b.Z, a.W + b.W);

        public static DoubleColumn operator -(in DoubleColumn a, in DoubleColumn b) =>
            new DoubleColumn(a.X - b.X, a.Y - b.Y, a.Z - b.Z, a.W - b.W);
    }
}
