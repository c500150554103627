// Stands in for HDRP's file of this name (17): the cascade of a position and its place in the atlas.
#ifndef STANDS_IN_FOR_HD_SHADOW_ALGORITHMS
#define STANDS_IN_FOR_HD_SHADOW_ALGORITHMS

int StandInCascadeOf(HDShadowContext context, float3 positionWS)
{
    for (uint i = 0; i < _CascadeShadowCount; ++i)
    {
        const float4 sphere = context.directionalShadowData.sphereCascades[i];
        const float3 fromCentre = positionWS - sphere.xyz;
        if (dot(fromCentre, fromCentre) <= sphere.w) return int(i);
    }
    return -1;
}

float3 StandInAtlasPosition(HDShadowData data, float3 positionWS)
{
    const float3 view = float3(dot(data.rot0, positionWS), dot(data.rot1, positionWS), dot(data.rot2, positionWS)) +
                        data.pos;
    const float2 tile = view.xy * data.proj.xy * 0.5 + 0.5;
    return float3(tile * data.shadowMapSize.xy * _CascadeShadowAtlasSize.zw + data.atlasOffset,
                  view.z * data.proj.z + data.proj.w);
}

#endif
