static const int N = 0;
int n; float2 v; float s; float3x3 m;
struct S { float a; float2 b; };
int Known(float4 p) { return 1; }
float4 Main(float4 p : SV_Position) : SV_Target
{
    float a = 1.0 / 0; float b = 1 / 0.0; int c = N > 0 ? 8 / N : 0; int d = 8 / n;
    uint2 e = ~asuint(p.xy); int f = ~n; bool g = !p.x; f = ~Known(p);
    float h = float(n); float2 i = float2(p.xy); float3 j = float3(p.x * 2, 1, Known(p)); float3x3 k;
    float2x2 l = float2x2(k); int4 o = int4(1, n, p.zw); float2 q = float2(p);
    float4 cast = (float4)s + ((float2x2)m)[0].xyxy + (float4)v.x + (float4)((float2)v).x;
    float4 r = p > 0 ? p : 1;
    float4 t = p > 0 ? 1 : 0;
    float3 u = p.x > 0 ? p.xyz : 1;
    float3 w = all(p > 0) ? p.xyz : p;
    float3 x = p.xyz > 0 ? p.xyz : p.yyy;
    uint suffixed = (7UL >> 1L) & 0xFFUL;
    int bits = dot(uint2(n, n), uint2(1, 2)) ^ n;
    S z = (S)0; float y[2] = { 1, 2 };
    return ~n ^ n << 2 | (n && p.x) || p.y == y[1] || z.a != 1;
}
