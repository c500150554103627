// Forward shader sample: the surface without lighting: its shadow caster, depth, and depth and normal passes.
#ifndef PENUMBRA_SAMPLE_DEPTH_PASSES_HLSL
#define PENUMBRA_SAMPLE_DEPTH_PASSES_HLSL

#include "SurfaceInput.hlsl"
// URP's Shadows.hlsl calls LerpWhiteTo, whose file it does not include itself.
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

// The direction or position of the light whose shadow map is drawn; URP sets the one that the keyword selects.
float3 _LightDirection;
float3 _LightPosition;

struct Attributes
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    half3 normalWS : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings DepthVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_TRANSFER_INSTANCE_ID(input, output);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
    output.normalWS = half3(TransformObjectToWorldNormal(input.normalOS));
    return output;
}

// Casters between the light and the map's near plane are moved onto the plane instead of being clipped.
float4 KeepOnNearPlane(float4 positionCS)
{
#if UNITY_REVERSED_Z
    positionCS.z = min(positionCS.z, positionCS.w * UNITY_NEAR_CLIP_VALUE);
#else
    positionCS.z = max(positionCS.z, positionCS.w * UNITY_NEAR_CLIP_VALUE);
#endif
    return positionCS;
}

Varyings CasterVertex(Attributes input)
{
    Varyings output = DepthVertex(input);
    const float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
#if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
    const float3 towardLightWS = normalize(_LightPosition - positionWS);
#else
    const float3 towardLightWS = _LightDirection;
#endif
    const float3 biasedWS = ApplyShadowBias(positionWS, TransformObjectToWorldNormal(input.normalOS), towardLightWS);
    output.positionCS = KeepOnNearPlane(TransformWorldToHClip(biasedWS));
    return output;
}

// URP reads depth from the red channel where a platform cannot sample its depth buffer.
half4 DepthFragment(Varyings input) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    return half4(input.positionCS.z, 0.0, 0.0, 0.0);
}

half4 NormalFragment(Varyings input) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    const float3 normalWS = normalize(float3(input.normalWS));
#if defined(_GBUFFER_NORMALS_OCT)
    const float2 octahedral = PackNormalOctQuadEncode(normalWS);
    return half4(PackFloat2To888(saturate(octahedral * 0.5 + 0.5)), 0.0);
#else
    return half4(normalWS, 0.0);
#endif
}

#endif
