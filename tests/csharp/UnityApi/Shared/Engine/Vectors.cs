namespace UnityEngine
{
    public struct Vector2 : IEquatable<Vector2>
    {
        public float x, y;

        public Vector2(float x, float y) { this.x = x; this.y = y; }

        public static Vector2 zero => new Vector2(0.0f, 0.0f);
        public static Vector2 one => new Vector2(1.0f, 1.0f);

        public bool Equals(Vector2 other) => x == other.x && y == other.y;
    }

    public partial struct Vector3 : IEquatable<Vector3>
    {
        public float x, y, z;

        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }

        public static Vector3 zero => new Vector3(0.0f, 0.0f, 0.0f);
        public static Vector3 one => new Vector3(1.0f, 1.0f, 1.0f);

        public bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;
    }

    public struct Vector3Int : IEquatable<Vector3Int>
    {
        public int x { get; set; }
        public int y { get; set; }
        public int z { get; set; }

        public Vector3Int(int x, int y, int z) { this.x = x; this.y = y; this.z = z; }

        public bool Equals(Vector3Int other) => x == other.x && y == other.y && z == other.z;
    }

    public struct Vector4 : IEquatable<Vector4>
    {
        public float x, y, z, w;

        public Vector4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }

        public static Vector4 zero => new Vector4(0.0f, 0.0f, 0.0f, 0.0f);

        public bool Equals(Vector4 other) => x == other.x && y == other.y && z == other.z && w == other.w;

        [OwnBehaviour] public override string ToString() => $"({x}, {y}, {z}, {w})";
    }
}

namespace UnityEngine
{
    public struct Color : IEquatable<Color>
    {
        public float r, g, b, a;

        public Color(float r, float g, float b, float a) { this.r = r; this.g = g; this.b = b; this.a = a; }

        public static Color white => new Color(1.0f, 1.0f, 1.0f, 1.0f);
        public static Color clear => new Color(0.0f, 0.0f, 0.0f, 0.0f);

        public bool Equals(Color other) => r == other.r && g == other.g && b == other.b && a == other.a;
    }
}
