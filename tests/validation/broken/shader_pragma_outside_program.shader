// shader_pragma_outside_program.shader:8:13: error: '#pragma' stands outside a program: move it between HLSLPROGRAM and ENDHLSL
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            #pragma vertex Vert
        }
    }
}
