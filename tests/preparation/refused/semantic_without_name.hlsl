// semantic_without_name.hlsl:2:25: error: expected 'layout, semantic, packoffset, or register', found ')'
float4 Main(float2 uv : ) : SV_Target { return 1; }
