// The passes of the Penumbra renderer feature. Each binds, calls the library and returns; a preset uses a few of them.
// Attenuation goes to the red channel: raw, with the shadow strength, without the distance fade.
Shader "Hidden/Penumbra/Shadows"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "Resolve"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment Resolve
            #pragma multi_compile_local_fragment _ _PENUMBRA_TENT_3X3 _PENUMBRA_TENT_7X7 _PENUMBRA_PCSS _PENUMBRA_PCSS_POISSON _PENUMBRA_PCSS_HDRP
            #include "ResolvePass.hlsl"
            ENDHLSL
        }
    }
}
