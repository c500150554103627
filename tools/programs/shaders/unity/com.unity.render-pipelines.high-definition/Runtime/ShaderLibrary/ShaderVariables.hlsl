// Stands in for HDRP's ShaderVariables.hlsl: the globals that Pipelines/Hdrp.hlsl and a full-screen custom pass read.
// Names and types are HDRP's interface (14 to 17); of its structs, the fields that are used.
#ifndef UNITY_SHADER_VARIABLES_INCLUDED
#define UNITY_SHADER_VARIABLES_INCLUDED

float4 _CascadeShadowAtlasSize; // width, height, 1/width, 1/height
uint _CascadeShadowCount;
int _DirectionalShadowIndex;
float4 _ScreenSize;
float4x4 unity_MatrixInvVP;
float4x4 unity_MatrixV;

#define UNITY_MATRIX_I_VP unity_MatrixInvVP
#define UNITY_MATRIX_V unity_MatrixV

#if UNITY_REVERSED_Z
#define UNITY_RAW_FAR_CLIP_VALUE 0.0
#else
#define UNITY_RAW_FAR_CLIP_VALUE 1.0
#endif

struct DirectionalLightData
{
    float3 forward;
    int shadowIndex;
    float shadowDimmer;
};

StructuredBuffer<DirectionalLightData> _DirectionalLightDatas;

Texture2D _CameraDepthTexture;

// Positions are relative to the camera.
float3 GetWorldSpaceViewDir(float3 positionRWS)
{
    return -positionRWS;
}

float LoadCameraDepth(uint2 pixel)
{
    return LOAD_TEXTURE2D_LOD(_CameraDepthTexture, pixel, 0).x;
}

struct PositionInputs
{
    float3 positionWS;
    uint2 positionSS;
};

PositionInputs GetPositionInput(float2 positionSS, float2 texelSize, float depth, float4x4 inverseViewProjection,
                                float4x4 view)
{
    const float2 ndc = (positionSS * texelSize) * float2(2.0, -2.0) + float2(-1.0, 1.0);
    const float4 position = mul(inverseViewProjection, float4(ndc, depth, 1.0));
    PositionInputs inputs;
    inputs.positionWS = position.xyz / position.w;
    inputs.positionSS = uint2(positionSS);
    return inputs;
}

#endif
