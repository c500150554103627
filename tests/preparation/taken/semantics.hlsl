// compile: --stage vertex --entry Vertex
// compile: --entry SystemValues
// compile: --entry Fetch
// compile: --entry Members
// compile: --entry OldTarget
// compile: --entry UnknownBeforeTheTarget
// compile: --entry OutParameters
// compile: --entry Interpolated
// compile: --stage hull --entry Hull
// compile: --stage vertex --entry TwoOfOneName
// compile: --entry EighthTarget
// compile: --stage vertex --entry VertexIds
// compile: --entry OldPosition
// compile: --stage compute --entry ThreadIds
struct V
{
    float4 p : SV_POSITION; uint i : SV_InstanceID; uint l : SV_RenderTargetArrayIndex;
    float c[2] : SV_ClipDistance0;
};
V Vertex(float4 p : SV_Position, uint v : SV_VertexID, uint i : SV_InstanceID) { V o = (V)0; return o; }

float4 SystemValues(float4 p : SV_Position, bool f : SV_IsFrontFace, uint s : SV_SampleIndex, uint c : SV_Coverage,
                    uint k : SV_PrimitiveID, uint i : SV_InstanceID, float x : MYSEM0) : SV_Target7 { return f; }

void Fetch(inout half4 c : SV_Target) { }

struct In { struct { float2 uv : TEXCOORD0; } m; };
struct Cascade
{
    float a; float2 b;
    float Sum() { return a; }
};
struct Out { half4 a : SV_TARGET0; float d : sv_depth; };
Out Members(In i, Cascade a : CASCADE, uniform float k, Texture2D t, bool f : SV_IsFrontFace, float face : VFACE)
{
    Out o = (Out)0;
    return o;
}

float4 OldTarget() : COLOR { return 1; }
float4 UnknownBeforeTheTarget(float t : A) : bogus : SV_Target { return 1; }
void OutParameters(float4 p : SV_Position, out float4 c : SV_Target, out float d : SV_Depth) { c = d = 1; }

typedef half real_t;
struct Normal { precise nointerpolation min16float3 n : NORMAL; real_t r : R; };
void Interpolated(const Normal v) { }

struct Corner { float3 p : INTERNALTESSPOS; };
struct Factors { float e[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
Factors Patch() { return (Factors)1; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("Patch")]
Corner Hull(InputPatch<Corner, 3> patch, uint id : SV_OutputControlPointID) { return patch[id]; }

struct Named { float4 p : SV_Position; float2 a[2] : T; float2 b : T2; };
Named TwoOfOneName(float4 p : POSITION, float2 q : T) { Named v = (Named)0; return v; }

float4 EighthTarget(float2 a : A, float4 b : B : register(c1)) : SV_Target7 { return 1; }
float4 VertexIds(float4 p : POSITION, int a : SV_VertexID, min16uint b : sv_instanceid) : SV_Position { return p; }
float4 OldPosition(bool face : SV_IsFrontFace, half4 p : VPOS) : SV_Target { return p; }
[numthreads(1, 1, 1)] void ThreadIds(uint2 a : SV_GroupThreadID, int3 b : SV_GroupID, uint c : SV_GroupIndex) {}
