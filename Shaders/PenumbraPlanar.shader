// Shadows flattened onto one plane, as `penumbra measure` runs them. The renderer feature does not have them, since it
// has URP's shadow map; the sample Planar Shadows draws them with a stencil bit.
Shader "Hidden/Penumbra/Planar"
{
    Properties
    {
        _BaseMap("Base map", 2D) = "white" {}
        _BaseColor("Base colour", Color) = (1, 1, 1, 1)
        _Cutoff("Alpha cutoff", Range(0, 1)) = 0.5
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "PlanarShadow"
            Blend One One
            BlendOp Max

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex PlanarVertex
            #pragma fragment PlanarShadow
            #pragma shader_feature_local _ALPHATEST_ON
            #include "PlanarPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "PlanarVisibility"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment PlanarVisibility
            #include "PlanarPasses.hlsl"
            ENDHLSL
        }
    }
}
