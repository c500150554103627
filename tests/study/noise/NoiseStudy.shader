// The pass of NoiseStudy.technique.json that is not the package's.
Shader "Hidden/Penumbra/NoiseStudy"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "ResolveWithNoise"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment ResolveWithNoise
            #pragma multi_compile_local_fragment _ _PENUMBRA_PCSS
            #pragma multi_compile_local_fragment _ NOISE_MASK
            #include "NoiseStudyPass.hlsl"
            ENDHLSL
        }
    }
}
