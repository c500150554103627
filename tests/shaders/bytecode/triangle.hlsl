// Two stages and what passes between them. triangle.dxbc is what FXC 10.0.26100 makes of it: Main, vs_4_0.
float4 _Offset;
struct Attributes
{
    float4 unread : COLOR;
    float3 position : POSITION;
    float2 uv : TEXCOORD1;
};
struct Varyings
{
    float4 position : SV_Position;
    float2 uv : TEXCOORD0;
};
Varyings Main(Attributes input)
{
    Varyings output;
    output.position = float4(input.position, 1.0) + _Offset;
    output.uv = input.uv;
    return output;
}
