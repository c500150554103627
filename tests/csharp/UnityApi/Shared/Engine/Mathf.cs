namespace UnityEngine;

public partial struct Mathf
{
    public const float Deg2Rad = PI * 2F / 360F;
    public const float PI = (float)Math.PI;

    public static float Sqrt(float f) => (float)Math.Sqrt(f);
    public static float Ceil(float f) => (float)Math.Ceiling(f);
    public static int CeilToInt(float f) => (int)Math.Ceiling(f);
    public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;
    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
    public static int Min(int a, int b) => a < b ? a : b;
    public static float Min(float a, float b) => a < b ? a : b;
    public static int Max(int a, int b) => a > b ? a : b;
    public static float Max(float a, float b) => a > b ? a : b;
}
