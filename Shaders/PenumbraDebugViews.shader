// Debug views of the renderer feature, one pass per view. Release players do not contain them: only the editor and
// development builds do.
Shader "Hidden/Penumbra/DebugViews"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "Visibility"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DebugVisibility
            #include "DebugPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "Cascades"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DebugCascades
            #include "DebugPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowTexels"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DebugShadowTexels
            #include "DebugPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "PenumbraWidth"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DebugPenumbraWidth
            #include "DebugPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "PenumbraMask"

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DebugPenumbraMask
            #include "DebugPass.hlsl"
            ENDHLSL
        }
    }
}
