// unknown_function.hlsl:4:12: error: no matching overloaded function found 'Brighten'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Brighten(uv.xyxy);
}
