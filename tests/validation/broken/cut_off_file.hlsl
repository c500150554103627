// cut_off_file.hlsl:5: error: unknown variable 'int'
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float shade = uv.x *
