float F(float x) { x = 1; }
float F(float2 x) { return 1; }
void V() { }
float H() { return F(1); }
void R(float a) { if (a > 0) return; }
float4 Main(float4 p : SV_Position) : SV_Target { F(p.xy); V(); R(1); return 1; }
