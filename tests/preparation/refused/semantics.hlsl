// semantics.hlsl:52:45: error: 'uv' has no semantic, and is an input of the fragment program
// semantics.hlsl:53:8: error: what 'Output' returns has no semantic, and is an output of the fragment program
// semantics.hlsl:54:44: error: 'uv' has no semantic, and is an input of the fragment program
// semantics.hlsl:56:21: error: 'n' has no semantic, and is an output of the fragment program
// semantics.hlsl:59:48: error: 'coordinates' has no semantic, and is an input of the geometry program
// semantics.hlsl:62:42: error: 'SV_Traget' is not a system value of HLSL; did you mean 'SV_Target'?
// semantics.hlsl:62:28: error: 'SV_Positon' is not a system value of HLSL; did you mean 'SV_Position'?
// semantics.hlsl:63:21: error: 'TEXCOORD0' is not an output of a fragment program
// semantics.hlsl:64:46: error: 'TEXCOORD0' is not an input of a compute program, which has SV_DispatchThreadID, SV_GroupID, SV_GroupIndex, SV_GroupThreadID
// semantics.hlsl:65:29: warning: 'POSITON' is not a vertex attribute of Unity's meshes; did you mean 'POSITION'?
// semantics.hlsl:66:26: error: 'SV_VertexID' is not an input of a fragment program
// semantics.hlsl:67:33: error: 'SV_Target' is not an input of a vertex program
// semantics.hlsl:68:38: error: 'SV_VertexID' is not an output of a vertex program
// semantics.hlsl:69:52: error: 'COLOR' is Direct3D 9's name of 'SV_Target', which the program has, too: write one of them
// semantics.hlsl:72:45: error: 'a' at semantics.hlsl:72 has the semantic 'sv_target0', too: give each output its own
// semantics.hlsl:74:63: error: 'm' at semantics.hlsl:74 has the semantic 'A1', too: give each output its own
// semantics.hlsl:76:82: warning: 'a' at semantics.hlsl:76 has the semantic 'TEXCOORD2', too: give each input its own
// semantics.hlsl:77:54: error: 'a' at semantics.hlsl:77 has the semantic 'Color0', too: give each input its own
// semantics.hlsl:78:73: error: 'b' at semantics.hlsl:78 has the semantic 'SV_VertexID', too: give each input its own
// semantics.hlsl:79:24: error: 'SV_Target8' does not exist: the targets are SV_Target0 to SV_Target7
// semantics.hlsl:80:37: error: 'TwoSemantics' has two semantics, 'SV_Target' and 'SV_Target1': write one of them
// semantics.hlsl:82:48: error: 'SV_VertexID' is an integer: declare it as uint
// semantics.hlsl:83:49: error: 'SV_InstanceID' is an integer: declare it as uint
// semantics.hlsl:84:31: error: 'SV_IsFrontFace' is a bool: declare it as one
// semantics.hlsl:85:47: error: 'SV_DispatchThreadID' is a vector of three integers: declare it as uint3, uint2 or uint
// semantics.hlsl:86:49: error: 'SV_GroupID' is a vector of three integers: declare it as uint3, uint2 or uint
// compile: --entry Input
// compile: --entry Output
// compile: --entry MemberOfAnInput
// compile: --entry MemberOfABase
// compile: --stage geometry --entry MemberOfAVertex
// compile: --entry Misspelt
// compile: --entry NoTarget
// compile: --stage compute --entry Kernel
// compile: --stage vertex --entry Attribute
// compile: --entry VertexId
// compile: --stage vertex --entry TargetAsInput
// compile: --stage vertex --entry VertexIdAsOutput
// compile: --entry TargetInTwoWords
// compile: --entry Outputs
// compile: --stage vertex --entry OutputsOfAMatrix
// compile: --entry InputsOfOneType
// compile: --entry InputsOfTwoTypes
// compile: --stage vertex --entry SystemValues
// compile: --entry NinthTarget
// compile: --entry TwoSemantics
// compile: --stage vertex --entry FloatId
// compile: --stage vertex --entry VectorId
// compile: --entry FloatFace
// compile: --stage compute --entry FourIds
// compile: --stage compute --entry FloatIds
float4 Input(float4 p : SV_Position, float2 uv) : SV_Target { return 1; }
float4 Output(float4 p : SV_Position) { return 1; }
struct In { float4 p : SV_Position; float2 uv, st : TEXCOORD1; };
float4 MemberOfAnInput(In i) : SV_Target { return 1; }
struct Base { half3 n[2]; };
struct Out : Base { float4 c : SV_Target; };
void MemberOfABase(out Out b) { b = (Out)0; }
struct Vertex { float4 p : SV_Position; float2 coordinates; };
[maxvertexcount(3)] void MemberOfAVertex(triangle Vertex v[3], inout TriangleStream<Vertex> s) { }

float4 Misspelt(float4 p : SV_Positon) : SV_Traget { return 1; }
float4 NoTarget() : TEXCOORD0 { return 1; }
[numthreads(1, 1, 1)] void Kernel(uint3 id : TEXCOORD0) { }
float4 Attribute(float4 p : POSITON) : SV_Position { return p; }
float4 VertexId(uint v : SV_VertexID) : SV_Target { return v; }
float4 TargetAsInput(float4 p : SV_Target) : SV_Position { return p; }
float4 VertexIdAsOutput(out uint v : SV_VertexID) : SV_Position { v = 0; return 1; }
struct Targets { float4 a : SV_Target0; float4 b : COLOR; };
Targets TargetInTwoWords() { return (Targets)1; }

struct O { float4 a : SV_Target; float4 b : sv_target0; };
O Outputs() { return (O)1; }
struct V { float4 p : SV_Position; float3x2 m : A; float2 b : A1; };
V OutputsOfAMatrix(float4 p : POSITION) { return (V)0; }
float4 InputsOfOneType(float2 a[2] : TEXCOORD1, float2 b : TEXCOORD0, float2 c : TEXCOORD2) : SV_Target { return 1; }
float4 InputsOfTwoTypes(float2 a : COLOR, float4 b : Color0) : SV_Target { return b; }
float4 SystemValues(float4 a : POSITION, uint b : SV_VertexID, uint c : SV_VertexID) : SV_Position { return b; }
float4 NinthTarget() : SV_Target8 { return 1; }
float4 TwoSemantics() : SV_Target : SV_Target1 { return 1; }

float4 FloatId(float4 p : POSITION, float id : SV_VertexID) : SV_Position { return p; }
float4 VectorId(float4 p : POSITION, uint2 id : SV_InstanceID) : SV_Position { return p; }
float4 FloatFace(float face : SV_IsFrontFace) : SV_Target { return face; }
[numthreads(1, 1, 1)] void FourIds(uint4 id : SV_DispatchThreadID) {}
[numthreads(1, 1, 1)] void FloatIds(float3 id : SV_GroupID) {}
