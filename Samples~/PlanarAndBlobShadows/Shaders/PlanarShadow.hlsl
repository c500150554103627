#ifndef PENUMBRA_SAMPLES_PLANAR_SHADOW_HLSL
#define PENUMBRA_SAMPLES_PLANAR_SHADOW_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/HeightFade.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/PlanarShadow.hlsl"

CBUFFER_START(UnityPerMaterial)
half4 _ShadowColor;
float _GroundMetres;
float _FadeMetres;
CBUFFER_END

// A caster's point that lies in the ground, or this near to it, casts nothing.
static const float kInGroundMetres = 1e-3;

struct PlanarAttributes
{
    float4 positionOS : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct PlanarVaryings
{
    float4 positionCS : SV_POSITION;
    float2 heightAndValid : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

PlanarVaryings PlanarVertex(PlanarAttributes input)
{
    PlanarVaryings output;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    const float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
    const float4 ground = float4(0.0, 1.0, 0.0, _GroundMetres);
    const PlanarPoint flat = OntoPlane(positionWS, ground, float4(GetMainLight().direction, 0.0));
    output.positionCS = TransformWorldToHClip(flat.position);
    output.heightAndValid = float2(flat.height, flat.valid ? 1.0 : 0.0);
    return output;
}

half4 PlanarFragment(PlanarVaryings input) : SV_Target
{
    // A triangle with a corner below the ground is valid at its other corners alone.
    clip(input.heightAndValid.y - 0.9999);
    clip(input.heightAndValid.x - kInGroundMetres);
    const half strength = half(HeightFade(input.heightAndValid.x, _FadeMetres));
    return half4(lerp(half3(1.0, 1.0, 1.0), _ShadowColor.rgb, strength), 1.0);
}

#endif
