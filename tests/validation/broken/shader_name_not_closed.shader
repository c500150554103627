// shader_name_not_closed.shader:2:8: error: this string is not closed on its line
Shader "Broken/Test
{
    SubShader { Pass { } }
}
