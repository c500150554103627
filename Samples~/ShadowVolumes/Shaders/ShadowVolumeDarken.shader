// Shadow volumes sample: multiplies the pixels that lie in at least one volume, and leaves 0 in the stencil.
Shader "Penumbra Samples/Shadow Volume Darken"
{
    Properties
    {
        _ShadowColor("Share of the Light in Shadow", Color) = (0.35, 0.38, 0.45, 1)
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "AlphaTest+49" "IgnoreProjector" = "True" }

        Pass
        {
            Name "ShadowVolumeDarken"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Cull Off
            ZTest Always
            ZWrite Off
            Blend DstColor Zero
            Stencil
            {
                Ref 0
                Comp NotEqual
                Pass Zero
            }

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex PictureVertex
            #pragma fragment PictureFragment
            #pragma multi_compile_instancing
            #include "ShadowVolumePass.hlsl"
            ENDHLSL
        }
    }
}
