// recursion_of_functions.hlsl:2:7: error: link: ERROR: Linking fragment stage: Recursion detected: Fade(f1; calling Fade(f1;
float Fade(float x)
{
    return x < 0.1 ? x : Fade(x * 0.5);
}
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Fade(uv.x);
}
