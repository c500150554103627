// value_returned_from_void.hlsl:5:5: error: void function cannot return a value 'return'
void Shade(out float4 colour)
{
    colour = 1.0;
    return colour;
}
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float4 colour;
    Shade(colour);
    return colour;
}
