// Forward shader sample: an opaque URP surface that filters the shadows of the sun and of spot lights itself, with
// Shadows.hlsl and SpotShadows.hlsl.
//
// The material selects the technique: each entry of the enum enables one keyword of Shadows.hlsl, and a build
// contains the techniques that its materials use. The entry "Tent 5x5" enables a keyword that the library does not
// have, and so selects its filter for no keyword.
Shader "Penumbra Samples/Forward Lit"
{
    Properties
    {
        [MainColor] _BaseColor("Color", Color) = (0.8, 0.8, 0.8, 1)
        [MainTexture] _BaseMap("Map", 2D) = "white" {}
        _Smoothness("Smoothness", Range(0, 1)) = 0.3
        _Metallic("Metallic", Range(0, 1)) = 0
        [Header(Shadow)]
        [KeywordEnum(Tent 5x5, Tent 3x3, Tent 7x7, Pcss, Pcss Poisson, Pcss Hdrp)] _Penumbra("Technique", Float) = 0
        _LampRadius("Radius of Lamps, m", Range(0, 0.5)) = 0.05
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }

        Pass
        {
            // "Only" makes URP's deferred path draw it, too, after its G-buffer, and take normals from
            // DepthNormalsOnly.
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForwardOnly" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ForwardVertex
            #pragma fragment ForwardFragment

            #pragma shader_feature_local_fragment _PENUMBRA_TENT_5X5 _PENUMBRA_TENT_3X3 _PENUMBRA_TENT_7X7 _PENUMBRA_PCSS _PENUMBRA_PCSS_POISSON _PENUMBRA_PCSS_HDRP

            // URP's keywords that this surface reads. Each of the three means that the main light has a shadow map;
            // which one it is does not matter here.
            #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHTS
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            // URP's keyword of Forward+ has another name from 17.1 on. There the earlier one brings a warning.
            #if UNITY_VERSION >= 60010000
            #pragma multi_compile_fragment _ _CLUSTER_LIGHT_LOOP
            #else
            #pragma multi_compile_fragment _ _FORWARD_PLUS
            #endif
            #pragma multi_compile_fog
            #pragma multi_compile_instancing
            #include "ForwardPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex CasterVertex
            #pragma fragment DepthFragment
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #pragma multi_compile_instancing
            #include "DepthPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex DepthVertex
            #pragma fragment DepthFragment
            #pragma multi_compile_instancing
            #include "DepthPasses.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormalsOnly" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex DepthVertex
            #pragma fragment NormalFragment
            #pragma multi_compile_fragment _ _GBUFFER_NORMALS_OCT
            #pragma multi_compile_instancing
            #include "DepthPasses.hlsl"
            ENDHLSL
        }
    }
}
