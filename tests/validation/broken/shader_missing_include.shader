// shader_missing_include.shader:12:13: error: cannot find 'parts/pallete.hlsl'; tried parts/pallete.hlsl; did you mean parts/palette.hlsl?
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            float4 Vert(float4 position : POSITION) : SV_Position { return position; }
            #include "parts/pallete.hlsl"
            float4 Frag() : SV_Target { return paletteScale; }
            ENDHLSL
        }
    }
}
