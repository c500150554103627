namespace UnityEngine;

public partial struct Mathf
{
    public static float Sin(float f) => (float)Math.Sin(f);
    public static float Cos(float f) => (float)Math.Cos(f);
    public static float Abs(float f) => Math.Abs(f);
    public static float Exp(float power) => (float)Math.Exp(power);
    public static float Pow(float f, float p) => (float)Math.Pow(f, p);

    public static float GammaToLinearSpace(float value) =>
        value <= 0.04045f ? value / 12.92f : Pow((value + 0.055f) / 1.055f, 2.4f);
}

public partial struct Vector3
{
    public static Vector3 up => new Vector3(0.0f, 1.0f, 0.0f);

    public Vector3 normalized => this * (1.0f / Mathf.Sqrt(Dot(this, this)));

    public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;

    public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
        new Vector3(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);

    public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3 operator *(Vector3 a, float d) => new Vector3(a.x * d, a.y * d, a.z * d);
}

public partial struct Quaternion : IEquatable<Quaternion>
{
    [OwnBehaviour] public Vector3 EulerDegrees { get; set; }

    public static Quaternion Euler(float x, float y, float z) => new Quaternion { EulerDegrees = new Vector3(x, y, z) };

    public bool Equals(Quaternion other) => EulerDegrees.Equals(other.EulerDegrees);
}

public partial struct Rect : IEquatable<Rect>
{
    public Rect(float x, float y, float width, float height) =>
        (this.x, this.y, this.width, this.height) = (x, y, width, height);

    public float x { get; set; }
    public float y { get; set; }
    public float width { get; set; }
    public float height { get; set; }

    public bool Equals(Rect other) => x == other.x && y == other.y && width == other.width && height == other.height;
}
