// A variance map from a multisampled depth map of the casters, cascade by cascade. The renderer feature does not have
// it, since it has URP's shadow map.
Shader "Hidden/Penumbra/MultisampledMaps"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off

        Pass
        {
            Name "CasterDepth"
            ZTest LEqual
            ZWrite On
            ZClip Off
            ColorMask 0
            Offset 2.5, 1

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex CasterVertex
            #pragma fragment CasterDepth
            #pragma shader_feature_local _ALPHATEST_ON
            #include "MultisampledMapPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MeanOfDepths"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment MeanOfDepths
            #include "MultisampledMapPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ValueRows"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment ValueRows
            #include "MultisampledMapPasses.hlsl"
            ENDHLSL
        }
    }
}
