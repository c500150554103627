// recursion_of_the_entry_point.hlsl:2:8: error: 'Main' calls itself: HLSL has no recursion
float4 Main(float4 p : SV_Position) : SV_Target { return p.x > 0 ? Main(p - 1) : p; }
