float _Power;
float4 Main(float2 uv : TEXCOORD0, nointerpolation int flat : TEXCOORD1) : SV_Target
{
    float a = pow(abs(uv.x), _Power);
    a += pow(saturate(uv.x), _Power);
    a += pow(max(uv.x, 0), _Power);
    a += pow(1 - saturate(uv.x), _Power);
    a += pow(uv.x * uv.x, _Power);
    a += pow(dot(uv, uv), _Power);
    a += pow(sqrt(uv.x), _Power);
    a += pow(exp(uv.x), _Power);
    a += pow(frac(uv.x), _Power);
    a += pow(length(uv), _Power);
    a += pow(0.5 + 0.5 * sin(uv.x), _Power);
    a += pow(smoothstep(0, 1, uv.x), _Power);
    a += pow(lerp(0.1, saturate(uv.x), saturate(uv.y)), _Power);
    a += pow(saturate(uv.x) / 3, _Power);
    a += pow(uv.x > 0.5 ? 1.0 : 0.25, _Power);
    a += pow(pow(abs(uv.y), 1.5), _Power);
    [loop] for (int i = 0; i < flat; ++i) a += pow(i + 0.5, _Power);
    a += pow(uv.x, 2);
    float4 v = float4(uv, 0.5, -1); v.z = clamp(v.z * uv.x, 0, 8);
    a += pow(v.z, _Power);
    float x = uv.x / uv.y;
    a += (asuint(x) & 0x7FFFFFFF) > 0x7F800000 ? 0 : x;
    a += x != uv.x ? 0 : x;
    return a + pow(uv, 5.0).xyxy;
}
