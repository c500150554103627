// template_of_hlsl_2021.hlsl:2:1: error: 'template' is a reserved word; the enum, operator and template of HLSL 2017 and 2021 are not supported
template <typename T> T Twice(T x) { return x + x; }
float4 Main(float4 p : SV_Position) : SV_Target { return Twice(p); }
