// registers.hlsl:4: error: '_B' and '_A' are used and have the same register: leave the registers out, as Unity binds by name, or give each its own
// registers.hlsl:6: error: 'D' and 'C' are used and have the same register: leave the registers out, as Unity binds by name, or give each its own
Texture2D _A[2] : register(t3);
Texture2D _B : register(t4);
cbuffer C : register(b1) { float c; }
cbuffer D : register(b1) { float d; }
float4 Main(float4 p : SV_Position) : SV_Target { return _A[0].Load(0) + _B.Load(0) + c + d; }
