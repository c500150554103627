// template_of_hlsl_2021.hlsl:2:1: error: Reserved word. 'template'
template <typename T> T Twice(T x) { return x + x; }
float4 Main(float4 p : SV_Position) : SV_Target { return Twice(p); }
