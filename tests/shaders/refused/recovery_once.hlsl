// recovery_once.hlsl:2:31: error: unknown variable 'one'
float First(float x) { return one; }
float Second(float x) { return one; }
float4 Main() : SV_Target { return First(1) + Second(2); }
