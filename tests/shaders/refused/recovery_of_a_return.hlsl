// recovery_of_a_return.hlsl:4:5: error: unknown function 'foo'
float4 Main() : SV_Target
{
    foo(1)
    return 1;
}
