// recovery_after_semicolon.hlsl:7:12: error: expected ';'
// recovery_after_semicolon.hlsl:10:32: error: unknown variable 'two'
struct S { float a; };
S First(float x)
{
    S s;
    s.a = 1
    return s;
}
float Second(float x) { return two; }
float4 Main() : SV_Target { return First(1).a; }
