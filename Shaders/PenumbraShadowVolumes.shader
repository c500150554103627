// Hard shadows by stencil shadow volumes, at the precision of the picture: the casters' depth, the volumes of the
// casters, and what is in none of them. The renderer feature does not have them; the sample Shadow Volumes draws them
// in URP.
Shader "Hidden/Penumbra/ShadowVolumes"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "IgnoreProjector" = "True" }
        Cull Off

        Pass
        {
            Name "SceneDepth"
            ZTest LEqual
            ZWrite On
            ColorMask 0

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex SceneVertex
            #pragma fragment SceneDepth
            #pragma shader_feature_local _ALPHATEST_ON
            #include "ShadowVolumePasses.hlsl"
            ENDHLSL
        }

        // A front face behind the depth ends a volume before it begins, as seen from infinity, and so counts one less.
        // Walls and far caps beyond the far plane are clamped to it instead of clipped. A cap lies behind the triangle
        // that it belongs to by a hundredth of a pixel's slope and a few steps of the depth, since rounding differs
        // with a triangle's winding: from the lit side the triangle is then before its volume, from the other side
        // inside of it.
        Pass
        {
            Name "CountVolumes"
            ZTest Less
            ZWrite Off
            ZClip False
            Offset 0.01, 4
            ColorMask 0
            Stencil
            {
                Comp Always
                ZFailFront DecrWrap
                ZFailBack IncrWrap
            }

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex VolumeVertex
            #pragma fragment CountVolumes
            #include "ShadowVolumePasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "VolumeVisibility"
            ZTest Always
            ZWrite Off
            Stencil
            {
                Ref 0
                Comp Equal
            }

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex ScreenTriangle
            #pragma fragment VolumeVisibility
            #include "VolumeVisibilityPass.hlsl"
            ENDHLSL
        }
    }
}
