// unknown_names.hlsl:11:16: error: 'Later' is declared only in line 20: move it before its first use, or declare it there
// unknown_names.hlsl:12:16: error: no function 'Sooner' takes these arguments; there is Sooner(float x)
// unknown_names.hlsl:13:15: error: unknown function 'fract'; HLSL has 'frac'
// unknown_names.hlsl:14:15: error: unknown function 'mod'; HLSL has 'fmod'
// unknown_names.hlsl:15:16: error: mul takes two arguments
// unknown_names.hlsl:16:26: error: '+=' cannot assign this value: its type cannot be converted to the variable's, or the variable is a bool
// unknown_names.hlsl:17:5: error: unknown type 'vec4'; HLSL has 'float4'
float4 Sooner(float x);
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    float4 a = Later(1);
    float4 b = Sooner();
    float d = fract(uv.x);
    float e = mod(uv.x, 2);
    float4 f = mul(uv, uv, 2);
    bool g = uv.x > 0; g += 1;
    vec4 c = 1;
    return 1;
}
float4 Later(float x) { return x; }
float4 Sooner(float x) { return x; }
