// compile: --stage compute --entry Kernel
// compile: --stage geometry --entry Geometry
// compile: --stage geometry --entry AsManyNumbersAsFit
// compile: --stage hull --entry Hull
// compile: --stage geometry --entry GeometryClip
// compile: --stage vertex --entry VertexClip
[numthreads(8, 8, 1)] void Kernel(uint3 id : SV_DispatchThreadID) { }

struct V { float4 p : SV_Position; float2 uv : TEXCOORD0; };
[maxvertexcount(3)] void Geometry(triangle V i[3], inout TriangleStream<V> s) { s.Append(i[0]); }
[maxvertexcount(170)] void AsManyNumbersAsFit(triangle V i[3], inout TriangleStream<V> s) { s.Append(i[0]); }

struct F { float e[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
F Patch(InputPatch<V, 3> p) { return (F)0; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("Patch")] V Hull(InputPatch<V, 3> p, uint i : SV_OutputControlPointID) { return p[i]; }

struct C { float4 p : SV_Position; float c : SV_ClipDistance0; };
struct I { float4 p : SV_Position; };
[maxvertexcount(3)] void GeometryClip(triangle I i[3], inout TriangleStream<C> s) {}
C VertexClip(float4 p : POSITION) { C c; c.p = p; c.c = 1; return c; }
