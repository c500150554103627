// The passes of the Penumbra renderer feature. Each binds, calls the library and returns; a frame uses a few of them.
// Attenuation is written to the red channel, with the shadow strength and without the distance fade. PCSS and other
// filters gather or search for bits, hence target 4.5: below graphicsShaderLevel 45 they have no program, and the
// feature draws Tent 7x7 instead. On OpenGL, OpenGL ES and WebGL, where raw reads of the shadow map are undefined,
// their programs compute that tent.
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
            Name "PenumbraMask"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment PenumbraMask
            #include "MaskPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MaskBlurHorizontal"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MaskBlurHorizontal
            #include "MaskPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MaskBlurVertical"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MaskBlurVertical
            #include "MaskPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "Resolve"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma target 4.5 _PENUMBRA_PCSS _PENUMBRA_PCSS_BOUNDED _PENUMBRA_PCSS_POISSON _PENUMBRA_PCSS_HDRP _PENUMBRA_ESM_LOG _PENUMBRA_SINGLE_LOOP _PENUMBRA_SINGLE_LOOP_MIN_MAX _PENUMBRA_SINGLE_LOOP_MIPS _PENUMBRA_SINGLE_LOOP_PLANES _PENUMBRA_VSSM_MIPS _PENUMBRA_MSSM_MIPS _PENUMBRA_EVSM_MIPS _PENUMBRA_SMRT _PENUMBRA_PCSS_GODOT _PENUMBRA_DPCF_FILAMENT _PENUMBRA_PCSS_FILAMENT
            #pragma vertex ScreenTriangle
            #pragma fragment Resolve
            #pragma multi_compile_local_fragment _ _PENUMBRA_TENT_3X3 _PENUMBRA_TENT_7X7 _PENUMBRA_PCSS _PENUMBRA_PCSS_BOUNDED _PENUMBRA_PCSS_POISSON _PENUMBRA_PCSS_HDRP _PENUMBRA_VSM _PENUMBRA_ESM _PENUMBRA_ESM_LOG _PENUMBRA_EVSM _PENUMBRA_MSM _PENUMBRA_SINGLE_LOOP _PENUMBRA_SINGLE_LOOP_MIN_MAX _PENUMBRA_SINGLE_LOOP_MIPS _PENUMBRA_SINGLE_LOOP_PLANES _PENUMBRA_VSSM _PENUMBRA_VSSM_MIPS _PENUMBRA_MSSM _PENUMBRA_MSSM_MIPS _PENUMBRA_EVSM_MIPS _PENUMBRA_SMRT _PENUMBRA_PCSS_GODOT _PENUMBRA_DPCF_FILAMENT _PENUMBRA_PCSS_FILAMENT
            #include "ResolvePass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DenoiseHorizontal"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment DenoiseHorizontal
            #include "DenoisePass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DenoiseVertical"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment DenoiseVertical
            #include "DenoisePass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ConservativeMask"

            HLSLPROGRAM
            // No pass may need more than 3.5 without a keyword: on OpenGL ES 3.0 and WebGL 2 all passes of this
            // SubShader would be lost.
            #pragma target 3.5
            #pragma target 4.5 _PENUMBRA_PCSS
            #pragma vertex ScreenTriangle
            #pragma fragment ConservativeMask
            #pragma multi_compile_local_fragment _ _PENUMBRA_PCSS
            #include "ConservativeMaskPass.hlsl"
            ENDHLSL
        }
    }
}
