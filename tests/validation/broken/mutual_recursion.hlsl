// mutual_recursion.hlsl:4:7: error: link: ERROR: Linking fragment stage: Recursion detected: Even(f1; calling Odd(f1;
float Odd(float x);
float Even(float x) { return x < 1.0 ? 1.0 : Odd(x - 1.0); }
float Odd(float x) { return x < 1.0 ? 0.0 : Even(x - 1.0); }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Even(uv.x);
}
