// divisions.hlsl:8: error: an integer is divided by zero
// divisions.hlsl:9: error: an integer is divided by zero
// divisions.hlsl:10: error: an integer is divided by zero
int _N; int2 _Texel;
float4 Main(float4 p : SV_Position) : SV_Target
{
    const uint zero = 3 - 3;
    int a = _N / 0;
    int2 b = _Texel % int2(1, 0);
    uint c = (uint)_N / zero;
    return a + b.xyxy + c;
}
