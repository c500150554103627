// stage_attributes.hlsl:21:6: error: 'NoGroup' has no [numthreads(x, y, z)], which a compute program needs
// stage_attributes.hlsl:22:2: error: [numthreads(x, y, z)] has three sizes, and 2 are given: write 1 for those that are not used
// stage_attributes.hlsl:25:6: error: 'NoVertexCount' has no [maxvertexcount(n)], which a geometry program needs
// stage_attributes.hlsl:26:58: error: a TriangleStream is changed by what is appended to it: write inout TriangleStream
// stage_attributes.hlsl:27:2: error: 171 vertices of 6 numbers are 1026, and a geometry program emits at most 1024 (X4552): at most 170 vertices
// stage_attributes.hlsl:32:3: error: 'NoFunction' has no [patchconstantfunc("Name")], which a hull program needs
// stage_attributes.hlsl:34:2: error: [patchconstantfunc] names 'Pach', and there is no such function
// stage_attributes.hlsl:36:46: error: 'SV_ClipDistance0' cannot be read in a geometry program here: pass the distance in a TEXCOORD, and write SV_ClipDistance in the geometry program
// stage_attributes.hlsl:36:46: error: 'SV_ClipDistance0' is not supported in a domain program
// compile: --stage compute --entry NoGroup
// compile: --stage compute --entry TwoSizes
// compile: --stage geometry --entry NoVertexCount
// compile: --stage geometry --entry StreamNotInout
// compile: --stage geometry --entry TooManyNumbers
// compile: --stage hull --entry NoFunction
// compile: --stage hull --entry UnknownFunction
// compile: --stage geometry --entry GeometryClip
// compile: --stage domain --entry DomainClip
RWBuffer<float> r;
[numthreads(8, 8, 1)] void Other() { }
void NoGroup(uint3 id : SV_DispatchThreadID) { }
[numthreads(8, 8)] void TwoSizes() { r[0] = 1; }

struct V { float4 p : SV_Position; float2 uv : TEXCOORD0; };
void NoVertexCount(triangle V i[3], inout TriangleStream<V> s) { s.Append(i[0]); }
[maxvertexcount(3)] void StreamNotInout(triangle V i[3], TriangleStream<V> s) { s.Append(i[0]); }
[maxvertexcount(171)] void TooManyNumbers(triangle V i[3], inout TriangleStream<V> s) { s.Append(i[0]); }

struct F { float e[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
F Patch(InputPatch<V, 3> p) { return (F)0; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
V NoFunction(InputPatch<V, 3> p, uint i : SV_OutputControlPointID) { return p[i]; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("Pach")] V UnknownFunction(InputPatch<V, 3> p, uint i : SV_OutputControlPointID) { return p[i]; }

struct C { float4 p : SV_Position; float c : SV_ClipDistance0; };
[maxvertexcount(3)] void GeometryClip(triangle C i[3], inout TriangleStream<C> s) {}
[domain("tri")] C DomainClip(float3 b : SV_DomainLocation) { C c; return c; }
