// suppression.hlsl:10:24: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 10: take it before the condition [divergent-derivative]
// suppression.hlsl:19:24: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 19: take it before the condition [divergent-derivative]
// suppression.hlsl:26:24: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 26: take it before the condition [divergent-derivative]
// suppression.hlsl:28:24: warning: a derivative is taken where only some pixels of a quad may be active, by the condition at line 28: take it before the condition [divergent-derivative]
// suppression.hlsl:28:66: warning: this comment disables an unknown rule, 'divergent-derivate'; did you mean 'divergent-derivative'? [unknown-rule]
// The rules find an expression once in a shader, so that each has a factor of its own.
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    float4 c = 0;
    if (uv.x > 1) c += ddx(uv.x * 2);

    if (uv.x > 2) c += ddx(uv.x * 3);  // penumbra-lint: disable=divergent-derivative

    // penumbra-lint: disable=divergent-derivative
    if (uv.x > 3) c += ddx(uv.x * 4);

    if (uv.x > 4) c += ddx(uv.x * 5);  // penumbra-lint: disable=typed-load, divergent-derivative

    if (uv.x > 5) c += ddx(uv.x * 6);  // penumbra-lint: disable=typed-load

    // penumbra-lint: disable=divergent-derivative
    // penumbra-lint: disable=typed-load
    if (uv.x > 6) c += ddx(uv.x * 7);

    c += 1;  // penumbra-lint: disable=divergent-derivative
    if (uv.x > 7) c += ddx(uv.x * 8);

    if (uv.x > 8) c += ddx(uv.x * 9);  // penumbra-lint: disable=divergent-derivate
    return c;
}
