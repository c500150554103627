// interfaces.hlsl:2:1: error: not supported here: interfaces, such as 'I'; take it out, name the struct itself where a parameter or variable has its type, and choose between structs with #if
interface I { float F(); };
class C : I { float F() { return 1; } };
float4 Main() : SV_Target { return 1; }
