// Passes over the shadow map: each makes, cascade by cascade, a map that may be filtered, or one of depth ranges.
Shader "Hidden/Penumbra/Maps"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZTest Always
        ZWrite Off
        Cull Off

        Pass
        {
            Name "VarianceRows"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MapRows
            #include "VarianceMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MomentRows"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MapRows
            #include "MomentMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ExponentialRows"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MapRows
            #include "ExponentialMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ExponentialVarianceRows"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MapRows
            #include "ExponentialVarianceMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MapColumns"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MapColumns
            #include "VarianceMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "LogExponentialRows"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment LogRows
            #include "LogExponentialMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "LogExponentialColumns"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment LogColumns
            #include "LogExponentialMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "QuarterDepthRange"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment QuarterDepthRange
            #include "DepthRangePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DilatedDepthRange"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DilatedDepthRange
            #include "DepthRangePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthRangeMip"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DepthRangeMip
            #include "DepthRangePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "QuarterVariance"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment QuarterVariance
            #include "DepthRangePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "QuarterDepthPlanes"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment QuarterDepthPlanes
            #include "DepthPlanePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthPlanesMip"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ScreenTriangle
            #pragma fragment DepthPlanesMip
            #include "DepthPlanePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthDigits"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment DepthDigitTexel
            #include "DigitMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MomentDigits"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment MomentDigitTexel
            #include "DigitMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "VarianceLevel"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FirstLevel
            #include "StoredVarianceMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MomentLevel"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FirstLevel
            #include "MomentMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ExponentialVarianceLevel"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment FirstLevel
            #include "ExponentialVarianceMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "NextLevel"
            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment NextLevel
            #include "MomentMap.hlsl"
            ENDHLSL
        }
    }
}
