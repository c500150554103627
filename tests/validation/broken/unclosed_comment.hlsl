// unclosed_comment.hlsl:4:5: error: '/*' is never closed
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    /* the shade of the surface
    return uv.xyxy;
}
