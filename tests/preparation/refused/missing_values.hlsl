// missing_values.hlsl:3:7: error: 'F' has no return statement: return a value, or make it void (not all control paths return a value, X3507)
// missing_values.hlsl:5:8: error: 'Main' has no return statement: return a value, or make it void (not all control paths return a value, X3507)
float F(float x) { x = 1; }
float G() { return F(1); }
float4 Main() : SV_Target { G(); discard; }
