namespace UnityEngine;

/// <summary>The entry mRC stands in row R and column C; the matrix acts on column vectors.</summary>
public partial struct Matrix4x4 : IEquatable<Matrix4x4>
{
    public float m00, m10, m20, m30, m01, m11, m21, m31, m02, m12, m22, m32, m03, m13, m23, m33;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
    {
        m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
        m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
        m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
        m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
    }

    public static Matrix4x4 identity => new Matrix4x4(new Vector4(1, 0, 0, 0), new Vector4(0, 1, 0, 0),
                                                      new Vector4(0, 0, 1, 0), new Vector4(0, 0, 0, 1));
    public static Matrix4x4 zero => default;

    public Vector4 GetColumn(int index)
    {
        switch (index)
        {
            case 0: return new Vector4(m00, m10, m20, m30);
            case 1: return new Vector4(m01, m11, m21, m31);
            case 2: return new Vector4(m02, m12, m22, m32);
            case 3: return new Vector4(m03, m13, m23, m33);
            default: throw new IndexOutOfRangeException("Invalid column index!");
        }
    }

    public Vector4 GetRow(int index)
    {
        switch (index)
        {
            case 0: return new Vector4(m00, m01, m02, m03);
            case 1: return new Vector4(m10, m11, m12, m13);
            case 2: return new Vector4(m20, m21, m22, m23);
            case 3: return new Vector4(m30, m31, m32, m33);
            default: throw new IndexOutOfRangeException("Invalid row index!");
        }
    }

    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) =>
        new Vector4(lhs.m00 * vector.x + lhs.m01 * vector.y + lhs.m02 * vector.z + lhs.m03 * vector.w,
                    lhs.m10 * vector.x + lhs.m11 * vector.y + lhs.m12 * vector.z + lhs.m13 * vector.w,
                    lhs.m20 * vector.x + lhs.m21 * vector.y + lhs.m22 * vector.z + lhs.m23 * vector.w,
                    lhs.m30 * vector.x + lhs.m31 * vector.y + lhs.m32 * vector.z + lhs.m33 * vector.w);

    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) =>
        new Matrix4x4(lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1), lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));

    public bool Equals(Matrix4x4 other) =>
        GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1)) &&
        GetColumn(2).Equals(other.GetColumn(2)) && GetColumn(3).Equals(other.GetColumn(3));
}
