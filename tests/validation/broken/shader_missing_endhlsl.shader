// shader_missing_endhlsl.shader:8:13: error: HLSLPROGRAM is not closed: no ENDHLSL follows
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            float4 Vert(float4 position : POSITION) : SV_Position { return position; }
        }
    }
}
