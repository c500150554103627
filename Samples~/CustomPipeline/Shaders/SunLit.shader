// Custom pipeline sample: a surface lit by one sun, with soft shadows from the Penumbra library.
Shader "Penumbra Samples/Custom Pipeline Lit"
{
    Properties
    {
        _BaseColor("Color", Color) = (0.8, 0.8, 0.8, 1)
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }

        Pass
        {
            Name "SunLit"
            Tags { "LightMode" = "PenumbraSampleLit" }

            HLSLPROGRAM
            // The filter gathers raw depths from the shadow map, which is undefined on OpenGL, OpenGL ES and WebGL.
            #pragma target 4.5
            #pragma vertex SunLitVertex
            #pragma fragment SunLitFragment
            #include "SunLitPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex SunCasterVertex
            #pragma fragment SunCasterFragment
            #include "SunCasterPass.hlsl"
            ENDHLSL
        }
    }
}
