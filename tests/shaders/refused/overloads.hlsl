// overloads.hlsl:5:36: error: several overloads of 'F' fit these arguments: cast the arguments to the types of one
// Unity's compilers would take the overload for uint.
int F(int a, int b) { return a; }
uint F(uint a, uint b) { return a; }
float4 Main() : SV_Target { return F(2u, -1); }
