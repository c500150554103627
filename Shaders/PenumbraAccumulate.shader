// The mean of the visibility over frames, after the passes of the Penumbra renderer feature that make it.
Shader "Hidden/Penumbra/Accumulate"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "Accumulate"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment Accumulate
            #include "AccumulatePass.hlsl"
            ENDHLSL
        }
    }
}
