// Contact shadows: after the passes of the Penumbra renderer feature, whose visibility they darken, or alone.
Shader "Hidden/Penumbra/ScreenTrace"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "ScreenTrace"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment ScreenTrace
            #include "ScreenTracePass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ScreenTraceAlone"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment ScreenTraceAlone
            #include "ScreenTracePass.hlsl"
            ENDHLSL
        }
    }
}
