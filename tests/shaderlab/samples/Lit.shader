// A comment with HLSLPROGRAM in it.
Shader "Samples/Lit" /* and /* one */ in another */
{
    Properties
    {
        [MainTexture] _BaseMap ("Albedo", 2D) = "white" {}
        [HDR] [MainColor] _BaseColor("Color", Color) = (1, .5, +0.25, 1)
        [Toggle(_ALPHATEST_ON)] _AlphaClip("Alpha clip", Float) = -1.5e-1
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Cull (2 = Back)", Int) = 2
        _Cutoff("Cutoff", Range(0.0, 1.0)) = 0.5
        [IntRange] _Ref ("Stencil", Range (-1, 255)) = 7
        _Offset("Offset", Vector) = (0, -1, 2)
        _Layers("Layers", 2DArray) = "" {}
        _Sky("Sky", Cube) = "_Skybox" { TexGen CubeReflect }
        _Volume("Volume", 3D) = "black" {}
        _Probes("Probes", CubeArray) = "" {}
        _Anything("Anything", Any) = "" {}
        _Old("Old", Rect) = "gray" {}
        _Count("Count", Integer) = 3
        [Header(Parts (a, b) of "x]y")] _Last("Last", Float) = 7.
    }

    HLSLINCLUDE
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
    float4 Shared() { return 1; } // ENDHLSL in a comment
    ENDHLSL

    Category
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        SubShader
        {
            PackageRequirements
            {
                "com.unity.render-pipelines.universal": "[14.0,17.0]"
                "unity"
            }
            Tags { "RenderType"="Opaque" "Queue" = "Geometry+10" }
            LOD 300
            Blend [_SrcBlend] [_DstBlend], One Zero ZWrite Off Cull[_Cull]
            Pass
            {
                Name "Forward"
                Tags { "LightMode" = "UniversalForward" }
                ZTest LEqual ColorMask RGB 1
                BlendOp Add, Max
                Offset -1, [_Bias]
                Stencil { Ref [_Ref] ReadMask 15 Comp Always Pass Replace ZFail Keep }
                Conservative True AlphaToMask On ZClip False
                HLSLPROGRAM
                #pragma vertex Vertex
                #pragma fragment Fragment
                float4 Vertex() : SV_Position { return Shared(); }
                float4 Fragment() : SV_Target { return 0; }
                ENDHLSL
            }
            UsePass "Samples/Lit/SHADOWCASTER"
            GrabPass { "_Grabbed" }
        }
    }
    SubShader
    {
        Pass
        {
            Name "ShadowCaster" HLSLPROGRAM float Cast() { return Late(); } ENDHLSL
        }
    }
    HLSLINCLUDE float Late() { return 2; }
    ENDHLSL
    Fallback "Hidden/InternalErrorShader"
    Dependency "BaseMapShader" = "Samples/Base"
    CustomEditor "Samples.LitGUI"
    CustomEditorForRenderPipeline "Samples.UrpGUI" "UniversalRenderPipelineAsset"
}
