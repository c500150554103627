int _N;
float4 Main(float4 p : SV_Position) : SV_Target
{
    const int zero = 0;
    if (zero != 0) return _N / zero;
    int unused = _N / 0;
    int i = (int)p.x & 1; uint2 u = asuint(p.xy) >> 3; i |= _N << 2; bool b = (p.x > 1) & (p.y > 2);
    return _N / 2.0 / 0.0 + _N % 3 + i + u.x + b;
}
