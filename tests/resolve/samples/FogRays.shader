// The light along the view ray of each pixel, up to the surface or 50 m. It is no technique for surfaces.
Shader "Hidden/Penumbra/Tests/FogRays"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "FogRays"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FogRays
            #include "FogRaysPass.hlsl"
            ENDHLSL
        }
    }
}
