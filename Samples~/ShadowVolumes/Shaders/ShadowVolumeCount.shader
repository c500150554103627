// Shadow volumes sample: counts in the stencil how many volumes each visible surface lies in, from behind it, so that
// the camera may be inside of volumes. Drawn after all other opaque objects, which must have left 0 in the stencil.
Shader "Penumbra Samples/Shadow Volume Count"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "AlphaTest+48" "IgnoreProjector" = "True" }

        Pass
        {
            Name "ShadowVolumeCount"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Cull Off
            ZTest Less
            ZWrite Off
            // Volumes end at the far plane instead of being cut open by it.
            ZClip False
            // Caps lie behind the triangles that they belong to: rounding makes no acne of them.
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
            #pragma fragment VolumeFragment
            #pragma multi_compile_instancing
            #include "ShadowVolumePass.hlsl"
            ENDHLSL
        }
    }
}
