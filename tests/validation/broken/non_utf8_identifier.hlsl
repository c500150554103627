// non_utf8_identifier.hlsl:4:12: error: unexpected byte 0xF6; is this file UTF-8?
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float höhe = uv.x;
    return höhe;
}
