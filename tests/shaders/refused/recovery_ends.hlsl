// recovery_ends.hlsl:9:28: error: unknown variable 'missing0'; did you mean 'missing1'?
// recovery_ends.hlsl:10:28: error: unknown variable 'missing1'; did you mean 'missing2'?
// recovery_ends.hlsl:11:28: error: unknown variable 'missing2'; did you mean 'missing3'?
// recovery_ends.hlsl:12:28: error: unknown variable 'missing3'; did you mean 'missing4'?
// recovery_ends.hlsl:13:28: error: unknown variable 'missing4'; did you mean 'missing5'?
// recovery_ends.hlsl:14:28: error: unknown variable 'missing5'; did you mean 'missing6'?
// recovery_ends.hlsl:15:28: error: unknown variable 'missing6'; did you mean 'missing7'?
// recovery_ends.hlsl:16:28: error: unknown variable 'missing7'; did you mean 'missing8'?
float F0(float x) { return missing0; }
float F1(float x) { return missing1; }
float F2(float x) { return missing2; }
float F3(float x) { return missing3; }
float F4(float x) { return missing4; }
float F5(float x) { return missing5; }
float F6(float x) { return missing6; }
float F7(float x) { return missing7; }
float F8(float x) { return missing8; }
float F9(float x) { return missing9; }
float4 Main() : SV_Target { return F0(1); }
