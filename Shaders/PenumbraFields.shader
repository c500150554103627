// Shadows of up to 16 objects from their distance fields, without a shadow map.
Shader "Hidden/Penumbra/Fields"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "FieldShadows"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FieldShadows
            #pragma multi_compile_local_fragment _ _PENUMBRA_FIELD_HARD _PENUMBRA_FIELD_CONE
            #include "FieldPass.hlsl"
            ENDHLSL
        }
    }
}
