// A sample beside the texture's edge tells how it is addressed.
#include "Platform/Platform.hlsl"
TEXTURE2D(_Picture);
SAMPLER(SAMPLER_NAME);
float4 _Picture_TexelSize;
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return SAMPLE_TEXTURE2D_LOD(_Picture, SAMPLER_NAME, float2(1.25, 0.5), 0.0).x + _Picture_TexelSize.z;
}
