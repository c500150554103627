// shader_misspelt_stage.shader:10:13: warning: unknown pragma 'fragmnet' has no effect; did you mean 'fragment'?
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragmnet Frag
            float4 Vert(float4 position : POSITION) : SV_Position { return position; }
            float4 Frag() : SV_Target { return 1.0; }
            ENDHLSL
        }
    }
}
