// The maps of casters that blend, such as wires and particles, cascade by cascade.
Shader "Hidden/Penumbra/Opacity"
{
    Properties
    {
        _BaseMap("Base map", 2D) = "white" {}
        _BaseColor("Base colour", Color) = (1, 1, 1, 1)
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZClip Off

        Pass
        {
            Name "BlendedOpacity"
            ZTest Always
            ZWrite Off
            Blend SrcAlpha OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex BlendedVertex
            #pragma fragment BlendedOpacity
            #include "OpacityPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "BlendedDepth"
            ZTest LEqual
            ZWrite On
            ColorMask 0

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex BlendedVertex
            #pragma fragment BlendedDepth
            #include "OpacityPasses.hlsl"
            ENDHLSL
        }
    }
}
