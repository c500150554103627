// URP's lighting as a project's own shader calls it, over 72 keyword sets.
#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
#pragma multi_compile _ _ADDITIONAL_LIGHTS_VERTEX _ADDITIONAL_LIGHTS
#pragma multi_compile _ _ADDITIONAL_LIGHT_SHADOWS
#pragma multi_compile _ _SHADOWS_SOFT
#pragma multi_compile _ LIGHTMAP_ON

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

half4 Fragment(float3 positionWS : TEXCOORD0, float3 normalWS : TEXCOORD1, float2 lightmapUV : TEXCOORD2) : SV_Target
{
    InputData place = (InputData)0;
    place.positionWS = positionWS;
    place.normalWS = normalize(normalWS);
    place.viewDirectionWS = normalize(_WorldSpaceCameraPos - positionWS);
    place.shadowCoord = TransformWorldToShadowCoord(positionWS);
    place.vertexLighting = VertexLighting(positionWS, place.normalWS);
    place.bakedGI = SAMPLE_GI(lightmapUV, SampleSH(place.normalWS), place.normalWS);
    place.shadowMask = half4(1, 1, 1, 1);
    SurfaceData surface = (SurfaceData)0;
    surface.albedo = half3(0.5, 0.5, 0.5);
    surface.smoothness = 0.5;
    surface.occlusion = 1.0;
    surface.alpha = 1.0;
    return UniversalFragmentPBR(place, surface);
}
