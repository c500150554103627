// Shadows of balls that stand for objects, as `penumbra measure` runs them. The renderer feature does not have them;
// the sample Blob Shadows draws them.
Shader "Hidden/Penumbra/Blobs"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "Blobs"

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment Blobs
            #include "BlobPass.hlsl"
            ENDHLSL
        }
    }
}
