// Shadows per sample at the edges of a multisampled picture, for pipelines that light it per sample. The renderer
// feature does not have them: when URP's screen-space shadows are drawn, its picture has no samples yet. OpenGL ES 3.1
// has no multisampled textures for two eyes at once.
Shader "Hidden/Penumbra/Edges"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        Cull Off

        Pass
        {
            Name "SampleSurface"
            ZTest LEqual
            ZWrite On

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex SurfaceVertex
            #pragma fragment SampleSurface
            #pragma shader_feature_local _ALPHATEST_ON
            #include "SampleSurfacePass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MarkSamples"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3
            #pragma vertex ScreenTriangle
            #pragma fragment MarkSamples
            #include "EdgePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MarkSurfaces"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3
            #pragma vertex ScreenTriangle
            #pragma fragment MarkSurfaces
            #include "EdgePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadePixels"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3
            #pragma vertex ScreenTriangle
            #pragma fragment ShadePixels
            #pragma multi_compile_local_fragment _ _PENUMBRA_PCSS
            #include "EdgePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadeSamples"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3
            #pragma vertex ScreenTriangle
            #pragma fragment ShadeSamples
            #pragma multi_compile_local_fragment _ _PENUMBRA_PCSS
            #include "EdgePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MeanOfSamples"
            ZTest Always
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3
            #pragma vertex ScreenTriangle
            #pragma fragment MeanOfSamples
            #include "EdgePasses.hlsl"
            ENDHLSL
        }
    }
}
