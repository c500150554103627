// shader_mistake_in_include_block.shader:5:40: error: unknown variable 'y'
Shader "Broken/Test"
{
    HLSLINCLUDE
    float Half(float x) { return 0.5 * y; }
    ENDHLSL
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            float4 Vert(float4 position : POSITION) : SV_Position { return position; }
            float4 Frag() : SV_Target { return Half(1.0); }
            ENDHLSL
        }
    }
}
