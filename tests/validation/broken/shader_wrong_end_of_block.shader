// shader_wrong_end_of_block.shader:10:13: error: ENDCG does not close the HLSLPROGRAM of line 8: write ENDHLSL
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            ENDCG
        }
    }
}
