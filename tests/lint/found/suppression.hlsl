// suppression.hlsl:10:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// suppression.hlsl:19:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// suppression.hlsl:26:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// suppression.hlsl:28:10: warning: pow of a base that may be negative gives NaN: bound it with abs, max or saturate [negative-pow]
// suppression.hlsl:28:53: warning: this comment disables an unknown rule, 'negativ-pow'; did you mean 'negative-pow'? [unknown-rule]
// The rules find an expression once in a shader, so that each has an exponent of its own.
float4 Main(float2 uv : TEXCOORD0) : SV_Target
{
    float4 c = 0;
    c += pow(uv.x, 1.5);

    c += pow(uv.x, 2.5);  // penumbra-lint: disable=negative-pow

    // penumbra-lint: disable=negative-pow
    c += pow(uv.x, 3.5);

    c += pow(uv.x, 4.5);  // penumbra-lint: disable=nan-check, negative-pow

    c += pow(uv.x, 5.5);  // penumbra-lint: disable=nan-check

    // penumbra-lint: disable=negative-pow
    // penumbra-lint: disable=nan-check
    c += pow(uv.x, 6.5);

    c += 1;  // penumbra-lint: disable=negative-pow
    c += pow(uv.x, 7.5);

    c += pow(uv.x, 8.5);  // penumbra-lint: disable=negativ-pow
    return c;
}
