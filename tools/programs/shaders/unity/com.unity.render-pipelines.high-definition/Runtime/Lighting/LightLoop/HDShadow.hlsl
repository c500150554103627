// Stands in for HDRP's file of this name (17): what its lit shaders call for the directional light.
// STAND_IN_TELLS_DATA: instead of visibility, number pixel.x of the shader data of cascade pixel.y.
#ifndef STANDS_IN_FOR_HD_SHADOW
#define STANDS_IN_FOR_HD_SHADOW

#if defined(STAND_IN_TELLS_DATA)
float StandInNumber(HDShadowData data, int which)
{
    const float numbers[12] = {data.dirLightPCSSParams0.x, data.dirLightPCSSParams0.y, data.dirLightPCSSParams0.z,
                               data.dirLightPCSSParams0.w, data.dirLightPCSSParams1.x, data.dirLightPCSSParams1.y,
                               data.dirLightPCSSParams1.z, data.dirLightPCSSParams1.w,
                               float(asint(data.shadowFilterParams0.y)), float(asint(data.shadowFilterParams0.z)),
                               data.worldTexelSize, data.normalBias};
    return numbers[which];
}
#endif

float GetDirectionalShadowAttenuation(inout HDShadowContext context, float2 positionSS, float3 positionWS,
                                      float3 normalWS, int first, float3 towardLight)
{
#if defined(STAND_IN_TELLS_DATA)
    return StandInNumber(context.shadowDatas[first + int(positionSS.y)], int(positionSS.x));
#else
    const int cascade = StandInCascadeOf(context, positionWS);
    if (cascade < 0) return 0.0; // not HDRP's answer: the caller must not ask
    const HDShadowData data = context.shadowDatas[first + cascade];
    const float3 normal = dot(normalWS, towardLight) < 0.0 ? -normalWS : normalWS;
    const float3 at = StandInAtlasPosition(data, positionWS + normal * data.normalBias * data.worldTexelSize);
    return StandInPcss(data, at, positionSS, _ShadowmapCascadeAtlas, s_linear_clamp_compare_sampler,
                       s_point_clamp_sampler);
#endif
}

#endif
