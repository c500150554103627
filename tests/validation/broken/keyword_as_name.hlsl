// keyword_as_name.hlsl:5:10: error: expected ';'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float sample = uv.x;
    float return = sample;
    return return;
}
