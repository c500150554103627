// Custom pipeline sample: a surface lit by one sun, whose soft shadow the Penumbra library computes.
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
            // The filter gathers, and reads the shadow map's depths: undefined on OpenGL, OpenGL ES and WebGL.
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
