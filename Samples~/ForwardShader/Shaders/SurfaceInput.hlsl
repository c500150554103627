// Forward shader sample: the material's uniforms. Every pass includes this one declaration of them, which is what
// makes the shader compatible with the SRP Batcher.
#ifndef PENUMBRA_SAMPLE_SURFACE_INPUT_HLSL
#define PENUMBRA_SAMPLE_SURFACE_INPUT_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

TEXTURE2D(_BaseMap);
SAMPLER(sampler_BaseMap);

CBUFFER_START(UnityPerMaterial)
float4 _BaseMap_ST;
half4 _BaseColor;
half _Smoothness;
half _Metallic;
half _LampRadius;
CBUFFER_END

#endif
