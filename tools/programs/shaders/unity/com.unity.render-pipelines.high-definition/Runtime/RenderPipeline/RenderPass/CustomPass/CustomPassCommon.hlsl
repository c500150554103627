// Stands in for HDRP's CustomPassCommon.hlsl: the triangle that covers the screen.
#ifndef CUSTOM_PASS_COMMON
#define CUSTOM_PASS_COMMON

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.high-definition/Runtime/ShaderLibrary/ShaderVariables.hlsl"

struct Attributes
{
    uint vertexID : SV_VertexID;
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
};

Varyings Vert(Attributes input)
{
    const float2 corner = float2(input.vertexID == 1 ? 3.0 : -1.0, input.vertexID == 2 ? 3.0 : -1.0);
    Varyings output;
    output.positionCS = float4(corner, UNITY_RAW_FAR_CLIP_VALUE, 1.0);
    return output;
}

#endif
