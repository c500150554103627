// shader_missing_semicolon.shader:14:34: error: expected ';'
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
                float shade = 0.5
                return shade;
            }
            ENDHLSL
        }
    }
}
