// extra_brace.hlsl:6:1: error: '}' closes nothing
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
}
