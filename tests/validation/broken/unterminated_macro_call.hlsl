// unterminated_macro_call.hlsl:5:12: error: the call of macro 'TWICE' is never closed
#define TWICE(a) ((a) * 2.0)
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    return TWICE(uv.x;
}
