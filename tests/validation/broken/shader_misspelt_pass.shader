// shader_misspelt_pass.shader:6:9: error: 'Pas' is not a command of ShaderLab: did you mean 'Pass'? (and its block holds a program)
Shader "Broken/Test"
{
    SubShader
    {
        Pas
        {
            HLSLPROGRAM
            #pragma vertex Vert
            ENDHLSL
        }
    }
}
