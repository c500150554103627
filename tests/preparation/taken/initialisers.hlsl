struct S { float a; float2 b; };
static const int N = 3;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float3 a = {1, p.xy}; float b[] = {1, 2, 3}; float c[N] = {1, 2, 3};
    S s = {1, 2, 3,}; S t[2] = {s, {1, {2, 3}}}; float2x2 m = {1, 2, 3, 4};
    float2 d[2] = {1, 2, float2(3, 4)}; float4 e = {mul(m, d[0]), d[1]}; float f = {1};
    float4 g = {abs(p)}; S v = (S)0; float3 h = {p.x, p.yz * 2};
    return 1;
}
