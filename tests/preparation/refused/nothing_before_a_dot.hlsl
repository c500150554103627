// nothing_before_a_dot.hlsl:3:1: error: expected ',' or ';' before 'float4'
.a
float4 Main() : SV_Target { return 1; }
