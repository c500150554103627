// extra_brace.hlsl:6: error: the HLSL front end cannot read on from here
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return uv.xyxy;
}
}
