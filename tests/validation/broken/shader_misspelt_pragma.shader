// shader_misspelt_pragma.shader:11:13: warning: unknown pragma 'multi_complie' has no effect; did you mean 'multi_compile'?
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            #pragma multi_complie _ _FOAM
            float4 Vert(float4 position : POSITION) : SV_Position { return position; }
            float4 Frag() : SV_Target { return 1.0; }
            ENDHLSL
        }
    }
}
