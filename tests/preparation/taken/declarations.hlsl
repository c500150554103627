static const float k[2] = { 1, 2 }; groupshared uint g; groupshared float g8[8]; row_major float4x4 m;
float F(const float a, in int b, out half c, inout bool d, nointerpolation uint e = 2)
{
    c = 1;
    [unroll] for (int i = 0; i < 2; ++i) float u = (float)i;
    [loop] while (d) int w = 1;
    if (d) float x = 1; else float y = 2;
    do int z = 3; while (d);
    switch (b) { case 0: float q = 1; break; default: int r = 2; break; }
    uint v = uint(a) + uint(float(b)); precise float s = k[1];
    return float(v) * float2(1, 2).x;
}
static const float b = 1; Texture2D<float4> t; uint u;
float4 G(in float x, const int y)
{
    [unroll(8)] for (;;) if (x) return 0; else return (float)x;
    switch (y) { case 1: return 2; break; default: return y; break; }
    return 1;
}

// Names may be those of other things.
struct A { float a; }; struct B { float a; }; A A2; float H(float x); float H(float x);
float H(float x) { float a = x; { float a = 2; } return a; } float2 H(float2 x) { return x; }
extern float e; extern float e; namespace N { float n; } namespace M { float n; } float n;
cbuffer P { float p1; }; cbuffer P { float p2; };

static float large[65536][0x10000];
static const float first[] = { 1, 2 }; static const int Three = 3; float sized[Three - 1][2];
float4 Main() : SV_Target
{
    float e2, g2; float H2 = 1; float interface = 1;
    // Two comparisons are no declaration of an array of no elements.
    int v[2], i; for (i = 0; i < 2 && (bool)(i > v[0]); ++i) {} while (i < 2 > v[0]) {}
    return 1;
}
