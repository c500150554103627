// bit_operators.hlsl:10: error: '&' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// bit_operators.hlsl:11: error: '|' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// bit_operators.hlsl:12: error: '^' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// bit_operators.hlsl:13: error: '<<' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// bit_operators.hlsl:14: error: '>>' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
// bit_operators.hlsl:15: error: '&' takes integers, and an operand is a float: convert it with (int), or read its bits with asuint()
int _N;
float4 Main(float4 p : SV_Position) : SV_Target
{
    float4 a = p.x & 1;
    float2 b = p.xy | 1;
    float4 c = p ^ p;
    float4 d = p.x << _N;
    float4 e = p.x >> 1;
    p.x &= 1;
    return a + b.xyxy + c + d + e + p;
}
