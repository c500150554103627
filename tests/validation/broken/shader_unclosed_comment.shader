// shader_unclosed_comment.shader:4:5: error: this comment is not closed: no */ follows
Shader "Broken/Test"
{
    /* the only sub shader
    SubShader { Pass { } }
}
