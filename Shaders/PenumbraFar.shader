// Shadows beyond the cascades: of mountains and hills, from what was baked of the ground, and of clouds.
Shader "Hidden/Penumbra/Far"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "FarShadows"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FarShadows
            #pragma multi_compile_local_fragment _ _PENUMBRA_FAR_HORIZON _PENUMBRA_FAR_HEIGHTS
            #pragma multi_compile_local_fragment _ _PENUMBRA_CLOUDS
            #include "FarPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "FarShadowsAlone"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FarShadowsAlone
            #pragma multi_compile_local_fragment _PENUMBRA_FAR_HORIZON _PENUMBRA_FAR_HEIGHTS
            #include "FarPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "CloudMap"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment CloudMap
            #include "CloudMapPass.hlsl"
            ENDHLSL
        }
    }
}
