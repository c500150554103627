// compile: --entry Main
// compile: --stage vertex --entry Vertex
// compile: --stage vertex --entry VertexOfAHelper
// compile: --stage geometry --entry Geometry
// compile: --stage geometry --entry Emitting
struct Surface { float3 albedo; float alpha; };
float Opaque(Surface s) { return s.albedo.x; }
Surface Make() { Surface s; s.alpha = 1; return s; }

float EveryPath(float a) { if (a > 0.5) return 1; else return 2; }
float EveryCase(int k) { switch (k) { case 0: return 1; default: return 2; } }
float EndlessLoop(int k) { while (true) { if (k > 3) return k; k++; } }
float Discarding(float a) { if (a > 0.5) return 1; discard; return 0; }

struct S { float a; float b; };
void Inner(float x, out float b) { b = x; }
void SetByACallee(float x, out S s) { s.a = x; Inner(x, s.b); }
void Inout(inout float b) { if (b > 2) b = 1; }
void Set(inout float a) { a = 1; }

float BothPaths(float x) { float a; if (x > 0.5) a = 1; else a = 2; return a; }
float4 UsedComponents(float2 uv) { float4 v; v.xy = uv; return v.xyyx; }
float LoopThatRuns() { float a; for (int i = 0; i < 4; ++i) a = i; return a; }
float LoopOfTwoConditions(float2 uv)
{
    float a;
    float4 c = float4(uv, -1, 1);
    while (c.z < 7 && c.w > 0.9) { c.z += 1; a = c.z; c.w = uv.x; }
    return a;
}
float LoopWithItsTestBelow(float2 uv) { float a; do { a = uv.x; } while (a > 2); return a; }
float FilledByIndex(int k) { float a[4]; for (int i = 0; i < 4; ++i) a[i] = i; return a[k] + a[2]; }
float PartlySet() { Surface s; s.albedo = 1; return Opaque(s); }
float3 Copied() { Surface s; s.albedo = 1; Surface t = s; return t.albedo; }
float Returned() { return Make().alpha; }
float OnlyWritten() { float a; Set(a); return a; }

float4 Main(float2 uv : TEXCOORD0, nointerpolation int flat : TEXCOORD1) : SV_Target
{
    S s; SetByACallee(uv.x, s);
    float b = 1; Inout(b);
    float4 sum = EveryPath(uv.x) + EveryCase(flat) + EndlessLoop(flat) + Discarding(uv.x) + s.b + b + BothPaths(uv.x);
    sum += UsedComponents(uv) + LoopThatRuns() + LoopOfTwoConditions(uv) + LoopWithItsTestBelow(uv);
    return sum + FilledByIndex(flat) + PartlySet() + Copied().xyzx + Returned() + OnlyWritten();
}

struct Varyings { float4 position : SV_Position; float2 uv : TEXCOORD0; float fog : TEXCOORD1; };
Varyings Vertex(float3 p : POSITION) { Varyings o = (Varyings)0; o.position = p.xyzz; return o; }
Varyings Half(float3 p) { Varyings o; o.position = p.xyzz; o.uv = p.xy; return o; }
Varyings VertexOfAHelper(float3 p : POSITION) { Varyings o = Half(p); o.fog = 1; return o; }

struct V { float4 p : SV_Position; float2 uv : TEXCOORD0; };
[maxvertexcount(3)] void Geometry(triangle V i[3], inout TriangleStream<V> s)
{
    for (int k = 0; k < 3; ++k)
    {
        V o; o.p = i[k].p; o.uv = i[k].uv;
        s.Append(o);
    }
}
void Emit(V v, inout TriangleStream<V> stream) { stream.Append(v); }
[maxvertexcount(3)] void Emitting(triangle V i[3], inout TriangleStream<V> s) { Emit(i[0], s); }
