int _N;
void F(inout float x) { x += 1; }
void G(float a, out float2 b) { b = a; }
struct S { float m; float4 n[2]; };
float4 Main(float4 p : SV_Position) : SV_Target
{
    float v = 1; F(v); float4 w = 1; F(w.y); F(w[_N]); float a[2] = { 1, 2 }; F(a[_N]);
    S s = (S)0; F(s.m); F(s.n[_N].z); int i = 1; float2 g; G(i + 1, g); G(1, w.zy);
    return v + w + a[0] + s.n[1] + i + g.xyxy;
}
