// written_arguments.hlsl:11: error: 'F' writes to its argument 1, which is not an lvalue: pass a variable
// written_arguments.hlsl:12: error: 'F' writes to its argument 1, which is not an lvalue: pass a variable
// written_arguments.hlsl:13: error: 'F' writes to its argument 1, which is not an lvalue: pass a variable
// written_arguments.hlsl:14: error: 'F' writes to its argument 1, which is not an lvalue: pass a variable
// written_arguments.hlsl:15: error: 'G' writes to its argument 2, which is not an lvalue: pass a variable
// written_arguments.hlsl:17: error: 'F' writes to its argument 1, which has another type: pass a variable of the parameter's type
void F(inout float x) { x += 1; }
void G(float a, out float2 b) { b = a; }
float4 Main(float4 p : SV_Position) : SV_Target
{
    F(1.0);
    F(p.x + 1);
    F(-p.x);
    const float k = 2; F(k);
    G(1, float2(1, 2));
    int i = 1;
    F(i);
    return i;
}
