// overloads.hlsl:5:36: error: ambiguous best function under implicit type conversion 'F'
// Unity's compilers would take the overload for uint.
int F(int a, int b) { return a; }
uint F(uint a, uint b) { return a; }
float4 Main() : SV_Target { return F(2u, -1); }
