// recursion_of_the_entry_point.hlsl:2:8: error: link: ERROR: Linking fragment stage: Recursion detected: Main(vf4; calling Main(vf4;
float4 Main(float4 p : SV_Position) : SV_Target { return p.x > 0 ? Main(p - 1) : p; }
