// duplicate_function.hlsl:3:7: error: function already has a body 'Half'
float Half(float x) { return 0.5 * x; }
float Half(float x) { return x / 2.0; }
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return Half(uv.x);
}
