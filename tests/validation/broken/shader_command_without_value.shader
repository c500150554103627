// shader_command_without_value.shader:9:9: error: expected a value for ZWrite, found '}'
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            ZWrite
        }
    }
}
