// integer_matrices.hlsl:4: error: '_M' is an integer matrix, which SPIR-V, GLSL and Metal cannot store in memory: declare an array of its rows, such as int2 rows[2]
// integer_matrices.hlsl:5: error: '_N' is an integer matrix, which SPIR-V, GLSL and Metal cannot store in memory: declare an array of its rows, such as int3 rows[2]
// integer_matrices.hlsl:6: error: '_O' is an integer matrix, which SPIR-V, GLSL and Metal cannot store in memory: declare an array of its rows, such as uint2 rows[2]
cbuffer C { float a; int2x2 _M; };
cbuffer D { int2x3 _N; };
uint2x2 _O;
float4 Main(float4 p : SV_Position) : SV_Target { return _M[int(p.x)].xyxy + _N[int(p.x)].xyxy + _O[int(p.x)].xyxy; }
