// unset_values.hlsl:39:7: error: not every path through 'ReturnsOnOnePath' returns a value [output-not-set]
// unset_values.hlsl:41:25: error: out parameter 'b' of 'NeverSet' is not set on every path [output-not-set]
// unset_values.hlsl:46:6: warning: out parameter 'b.y' of 'SetOnOnePath' is not set on every path [output-not-set]
// unset_values.hlsl:47:6: error: out parameter 's.b', 's.c[0]' of 'SetInPart' is not set on every path [output-not-set]
// unset_values.hlsl:50: warning: 'b' is read before it is set on every path [read-before-set]
// unset_values.hlsl:56:16: warning: 'a' is read but never set [read-before-set]
// unset_values.hlsl:61:12: warning: 'a' is read before it is set on every path [read-before-set]
// unset_values.hlsl:66:12: warning: 'v.z' is read but never set [read-before-set]
// unset_values.hlsl:71:12: warning: 'v.z', 'v.w' is read but never set [read-before-set]
// unset_values.hlsl:76:12: warning: 'a' is read before it is set on every path [read-before-set]
// unset_values.hlsl:81:12: warning: 'a' is read before it is set on every path [read-before-set]
// unset_values.hlsl:86:12: warning: 'a[2]' is read but never set [read-before-set]
// unset_values.hlsl:91:20: warning: 's.alpha' is passed to 'Blended', which reads it, but never set [read-before-set]
// unset_values.hlsl:96:20: warning: 's.alpha' is passed to 'Through', which reads it, but never set [read-before-set]
// unset_values.hlsl:101:18: warning: 's.alpha' is passed to 'Outer', which reads it, but never set [read-before-set]
// unset_values.hlsl:103:67: warning: 't.alpha' is read before it is set on every path [read-before-set]
// unset_values.hlsl:104:35: warning: 'albedo' of what 'Make' returns is read, but not set on every path [read-before-set]
// unset_values.hlsl:108:9: warning: 'a' is passed to 'Add', which reads it, before it is set on every path [read-before-set]
// unset_values.hlsl:127:5: warning: output 'uv.y', 'fog' of 'Vertex' is not set on every path [output-not-set]
// unset_values.hlsl:130:49: warning: output 'fog' of 'VertexOfAHelper' is not set on every path [output-not-set]
// unset_values.hlsl:132:54: warning: what 'VertexOfAnUnsetValue' returns is not set on every path [output-not-set]
// unset_values.hlsl:140:18: warning: 'o.uv' is read but never set [read-before-set]
// unset_values.hlsl:143:58: error: out parameter 'x' of 'Emit' is not set on every path [output-not-set]
// compile: --entry Main
// compile: --stage vertex --entry Vertex
// compile: --stage vertex --entry VertexOfAHelper
// compile: --stage vertex --entry VertexOfAnUnsetValue
// compile: --stage geometry --entry Geometry
// compile: --stage geometry --entry Emitting
struct Surface { float3 albedo; float alpha; };
float Blended(Surface s) { return s.albedo.x * s.alpha; }
float Through(Surface s) { return Blended(s); }
void Maybe(inout float a, float b) { if (b > 2) a = b; }
float Outer(Surface s) { Maybe(s.alpha, s.albedo.x); return s.alpha; }
Surface Make() { Surface s; s.alpha = 1; return s; }
void Add(inout float a) { a += 1; }

struct S { float2 a; float b; float c[2]; };
float ReturnsOnOnePath(float a) { if (a > 0.5) return 1; }
void NeverSet(float a,
              out float b)
{
    a += 1;
}
float Caller(float a) { float b; NeverSet(a, b); return b; }  // one cause, one finding
void SetOnOnePath(float a, out float2 b) { b.x = 0; if (a > 0) b.y = 1; }
void SetInPart(float a, out S s) { s.a = a; s.c[1] = 0; }
void ReadsItsOutput(out float b)
{
    b = b + 1;
}

float NeverWritten(float x)
{
    float a;
    return x + a;
}
float WrittenOnOnePath(float x)
{
    float a; if (x > 0.5) a = 1;
    return a;
}
float4 OneComponent(float2 uv)
{
    float4 v; v.xy = uv;
    return v.xyzx;
}
float4 TwoComponents(float2 uv)
{
    float4 v; v.xy = uv;
    return v * 2;
}
float LoopThatMayNotRun(int n)
{
    float a; for (int i = 0; i < n; ++i) a = i;
    return a;
}
float LoopOfAnUnknownBound(int k)
{
    float a; int n = 4; n -= k; for (int i = 0; i < n; ++i) a = i;
    return a;
}
float Element()
{
    float a[4]; a[0] = 1;
    return a[2];
}
float PassedOn()
{
    Surface s; s.albedo = 1;
    return Blended(s);
}
float PassedThrough()
{
    Surface s; s.albedo = 1;
    return Through(s);
}
float PassedToChange()
{
    Surface s; s.albedo = 1;
    return Outer(s);
}
float Copied() { Surface s; s.albedo = 1; Surface t = s; return t.alpha; }
float3 Returned() { return Make().albedo; }
float Inout()
{
    float a;
    Add(a);
    return a;
}

float4 Main(float2 uv : TEXCOORD0, nointerpolation int flat : TEXCOORD1) : SV_Target
{
    float2 b; SetOnOnePath(uv.x, b);
    S s; SetInPart(uv.x, s);
    float o = 1; ReadsItsOutput(o);
    float4 sum = ReturnsOnOnePath(uv.x) + Caller(uv.x) + b.xyxy + s.a.xxxx + o + NeverWritten(uv.x);
    sum += WrittenOnOnePath(uv.x) + OneComponent(uv) + TwoComponents(uv) + LoopThatMayNotRun(flat);
    sum += LoopOfAnUnknownBound(flat) + Element() + PassedOn() + PassedThrough() + PassedToChange() + Copied();
    return sum + Returned().xyzz + Inout();
}

struct Varyings { float4 position : SV_Position; float2 uv : TEXCOORD0; float fog : TEXCOORD1; };
Varyings Vertex(float3 p : POSITION)
{
    Varyings o; o.position = p.xyzz; o.uv.x = p.x;
    return o;
}
Varyings Half(float3 p) { Varyings o; o.position = p.xyzz; o.uv = p.xy; return o; }
Varyings VertexOfAHelper(float3 p : POSITION) { return Half(p); }
Varyings Unset() { Varyings o; return o; }
Varyings VertexOfAnUnsetValue(float3 p : POSITION) { return Unset(); }

struct V { float4 p : SV_Position; float2 uv : TEXCOORD0; };
[maxvertexcount(3)] void Geometry(triangle V i[3], inout TriangleStream<V> s)
{
    for (int k = 0; k < 3; ++k)
    {
        V o; o.p = i[k].p;
        s.Append(o);
    }
}
void Emit(V v, inout TriangleStream<V> stream, out float x) { stream.Append(v); }
[maxvertexcount(3)] void Emitting(triangle V i[3], inout TriangleStream<V> s) { float x; Emit(i[0], s, x); }
