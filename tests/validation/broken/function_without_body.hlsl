// function_without_body.hlsl:2:7: error: link: ERROR: Linking fragment stage: No function definition (body) found: Fade(f1;
float Fade(float x);
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Fade(uv.x);
}
