// unknown_names.hlsl:18:16: error: no matching overloaded function found 'Later'
// unknown_names.hlsl:20:16: error: no matching overloaded function found 'Sooner'
// unknown_names.hlsl:22:15: error: no matching overloaded function found 'fract'
// unknown_names.hlsl:24:15: error: no matching overloaded function found 'mod'
// unknown_names.hlsl:26:16: error: expected: mul arguments
// unknown_names.hlsl:28:26: error: could not create assignment
// unknown_names.hlsl:30:5: error: unknown variable 'vec4'
// compile: -D ERROR=0
// compile: -D ERROR=1
// compile: -D ERROR=2
// compile: -D ERROR=3
// compile: -D ERROR=4
// compile: -D ERROR=5
// compile: -D ERROR=6
float4 Sooner(float x);
float4 Main(float2 uv : TEXCOORD0) : SV_Target {
#if ERROR == 0
    float4 a = Later(1);
#elif ERROR == 1
    float4 b = Sooner();
#elif ERROR == 2
    float d = fract(uv.x);
#elif ERROR == 3
    float e = mod(uv.x, 2);
#elif ERROR == 4
    float4 f = mul(uv, uv, 2);
#elif ERROR == 5
    bool g = uv.x > 0; g += 1;
#elif ERROR == 6
    vec4 c = 1;
#endif
    return 1;
}
float4 Later(float x) { return x; }
float4 Sooner(float x) { return x; }
