Shader "Hidden/Means" { SubShader {
Pass { Name "Depths" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Depths
#include "MeansPasses.hlsl"
ENDHLSL }
Pass { Name "Rows" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Rows
#include "MeansPasses.hlsl"
ENDHLSL }
Pass { Name "Columns" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Columns
#include "MeansPasses.hlsl"
ENDHLSL }
Pass { Name "Mips" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Mips
#include "MeansPasses.hlsl"
ENDHLSL } } }
