// shader_pragma_outside_program.shader:8:13: error: '#pragma' is outside a program: move it between HLSLPROGRAM and ENDHLSL
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
