// Passes over the shadow map: each makes, cascade by cascade, a map that may be filtered.
Shader "Hidden/Penumbra/Maps"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "VarianceRows"
            HLSLPROGRAM
            #pragma vertex ScreenTriangle
            #pragma fragment VarianceRows
            #include "MomentPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MomentColumns"
            HLSLPROGRAM
            #pragma vertex ScreenTriangle
            #pragma fragment MomentColumns
            #include "MomentPasses.hlsl"
            ENDHLSL
        }
    }
}
