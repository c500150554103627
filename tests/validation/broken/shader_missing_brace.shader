// shader_missing_brace.shader:11:1: error: expected '}' for the Shader of line 2, found the end of the file
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            Cull Off
    }
}
