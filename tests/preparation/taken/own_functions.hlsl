Texture2D t;
float4 tex2D(Texture2D t, float2 uv) { return t.Load(int3(uv, 0)); }
float4 max(Texture2D a, int b) { return a.Load(int3(b, 0, 0)); }
uint msad4(uint a) { return a; }
float4 Main(float2 uv : TEXCOORD0) : SV_Target { return tex2D(t, uv) + max(t, 1) + msad4(1); }
