// written_arguments.hlsl:7: error: 'F' writes to its argument 1, which has another type: pass a variable of the parameter's type
void F(inout float x) { x += 1; }
float4 Main(float4 p : SV_Position) : SV_Target
{
    float x = p.x; F(x);
    int i = 1;
    F(i);
    return i + x;
}
