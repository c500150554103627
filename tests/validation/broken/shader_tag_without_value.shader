// shader_tag_without_value.shader:6:29: error: expected '=' after the tag "RenderType", found "Opaque"
Shader "Broken/Test"
{
    SubShader
    {
        Tags { "RenderType" "Opaque" }
        Pass { }
    }
}
