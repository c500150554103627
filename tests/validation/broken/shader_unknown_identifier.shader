// shader_unknown_identifier.shader:14:24: error: unknown variable 'glow'
Shader "Broken/Test"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            float4 Vert(float4 position : POSITION) : SV_Position { return position; }
            float4 Frag() : SV_Target
            {
                return glow;
            }
            ENDHLSL
        }
    }
}
