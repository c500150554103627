// parts/first.hlsl:3:9: error: unknown variable 'uno'
// recovery_in_functions.hlsl:15:15: error: unknown variable 'one'
// recovery_in_functions.hlsl:16:9: error: unknown variable 'two'
// recovery_in_functions.hlsl:18:13: error: unknown variable 'three'
// recovery_in_functions.hlsl:22:35: error: unknown variable 'four'
#include "parts/first.hlsl"
// Operators of two characters are one token for the parser.
bool Before(int a)
{
    a += 1; a -= 1; a <<= 2;
    return a == 1 && a != 2 || a >= 3;
}
float Second(float x)
{
    float a = one; float b = 2;
    x = two;
    if (x > 1) {
        x = three;
    }
    return a + x + b;
}
float Third(float x) { return 2 * four; }
float4 Main() : SV_Target { return First(1) + Second(2) + Third(3); }
