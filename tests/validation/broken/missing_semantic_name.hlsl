// missing_semantic_name.hlsl:2:56: error: expected 'layout, semantic, packoffset, or register', found ')'
float4 Main(float4 position : SV_Position, float2 uv : ) : SV_Target
{
    return uv.xyxy;
}
