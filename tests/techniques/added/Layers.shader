Shader "Hidden/Layers" {
Properties { _BaseMap("Base map", 2D) = "white" {} _BaseColor("Base colour", Color) = (1, 1, 1, 1) _Cutoff("Cutoff", Float) = 0.5 }
SubShader { Cull Off
Pass { Name "Nearest" ZWrite On ZTest LEqual ColorMask 0 HLSLPROGRAM
#pragma vertex Caster
#pragma fragment Nearest
#pragma shader_feature_local _ALPHATEST_ON
#include "LayersPasses.hlsl"
ENDHLSL }
Pass { Name "Layers" ZWrite Off ZTest Always Blend One One HLSLPROGRAM
#pragma vertex Caster
#pragma fragment Layers
#pragma shader_feature_local _ALPHATEST_ON
#include "LayersPasses.hlsl"
ENDHLSL } } }
