// recovery_in_statements.hlsl:9:16: error: unknown function 'missing'
// recovery_in_statements.hlsl:10:10: error: unknown variable 'two'
// recovery_in_statements.hlsl:11:7: error: '.k' is not a swizzle
// recovery_in_statements.hlsl:12:12: error: expected ';'
// recovery_in_statements.hlsl:13:15: error: unknown variable 'four'; did you mean 'Foo'?
// recovery_in_statements.hlsl:14:16: error: unknown function 'Foo'
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    float4 v = missing(uv);
    v += two;
    v.k = 1;
    v.x = 2
    v.y = 3 + four;
    return v + Foo(1);
}
