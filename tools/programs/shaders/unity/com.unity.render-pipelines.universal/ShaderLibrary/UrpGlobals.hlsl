// The globals of Unity's URP that Pipelines/Urp.hlsl reads, declared so that the library's URP side compiles and runs
// without Unity. Names, types and array lengths are URP's interface (14 to 17); include it after the platform macros.
#ifndef UNIVERSAL_SHADOWS_INCLUDED
#define UNIVERSAL_SHADOWS_INCLUDED

float4x4 _MainLightWorldToShadow[5];
float4 _CascadeShadowSplitSpheres0;
float4 _CascadeShadowSplitSpheres1;
float4 _CascadeShadowSplitSpheres2;
float4 _CascadeShadowSplitSpheres3;
float4 _CascadeShadowSplitSphereRadii; // squared
float4 _MainLightShadowParams;         // x: strength

TEXTURE2D_SHADOW(_MainLightShadowmapTexture);
TEXTURE2D_X(_ScreenSpaceShadowmapTexture);

#endif
