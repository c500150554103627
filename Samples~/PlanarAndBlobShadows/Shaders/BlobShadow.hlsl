#ifndef PENUMBRA_SAMPLES_BLOB_SHADOW_HLSL
#define PENUMBRA_SAMPLES_BLOB_SHADOW_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/BlobShadow.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Core/PlanarShadow.hlsl"

CBUFFER_START(UnityPerMaterial)
half4 _ShadowColor;
float _RadiusMetres;
float _GroundMetres;
float _HalfDiameter;
float _FadeMetres;
CBUFFER_END

// The sine of the sun's smallest height, 3 degrees: under a lower sun the shadow would leave its square.
static const float kLowestSun = 0.05;

// Half the side of the square's mesh, which is so large that the shadow lies within the bounds that Unity culls by.
static const float kMeshHalfSide = 10.0;

struct BlobAttributes
{
    float4 positionOS : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct BlobVaryings
{
    float4 positionCS : SV_POSITION;
    float3 positionWS : TEXCOORD0;
    float4 ball : TEXCOORD1;
    UNITY_VERTEX_OUTPUT_STEREO
};

// The square around the shadow: its half length holds the ball's shadow on the ground and the penumbra around that.
BlobVaryings BlobVertex(BlobAttributes input)
{
    BlobVaryings output;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    const float3 centre = TransformObjectToWorld(float3(0.0, 0.0, 0.0));
    const float3 towardSun = GetMainLight().direction;
    const PlanarPoint onGround = OntoPlane(centre, float4(0.0, 1.0, 0.0, _GroundMetres), float4(towardSun, 0.0));
    const float rise = max(towardSun.y, kLowestSun);
    const float reach = (_RadiusMetres + onGround.height / rise * tan(_HalfDiameter)) / rise;
    const float2 side = reach / kMeshHalfSide * input.positionOS.xz;
    output.positionWS = float3(onGround.position.x + side.x, _GroundMetres, onGround.position.z + side.y);
    output.positionCS = TransformWorldToHClip(output.positionWS);
    output.ball = float4(centre, _RadiusMetres);
    return output;
}

half4 BlobFragment(BlobVaryings input) : SV_Target
{
    const float4 towardSun = float4(GetMainLight().direction, _HalfDiameter);
    const float visibility = BlobVisibility(input.positionWS, float3(0.0, 1.0, 0.0), input.ball, towardSun,
                                            _FadeMetres);
    return half4(lerp(_ShadowColor.rgb, half3(1.0, 1.0, 1.0), half(visibility)), 1.0);
}

#endif
