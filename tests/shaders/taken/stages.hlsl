// compile: --entry Fragment
// compile: --stage vertex --entry Vertex
groupshared float Shared[4];
static const int2x2 _M = {1, 2, 3, 4};
void Cut(float a) { clip(a); }
float4 Fragment(float4 p : SV_Position) : SV_Target { return p + _M[int(p.x)].xyxy; }
float4 Vertex(float4 p : POSITION) : SV_Position { return p; }
