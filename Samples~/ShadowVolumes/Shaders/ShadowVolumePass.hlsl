// Shadow volumes sample: the volumes, whose colour nobody writes, and the triangle that darkens what lies in them.
#ifndef PENUMBRA_SAMPLE_SHADOW_VOLUME_PASS_HLSL
#define PENUMBRA_SAMPLE_SHADOW_VOLUME_PASS_HLSL

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

CBUFFER_START(UnityPerMaterial)
half4 _ShadowColor;
CBUFFER_END

struct Attributes
{
    float4 positionOS : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    UNITY_VERTEX_OUTPUT_STEREO
};

// These are the steps of URP's own shaders, so that a cap has the depth of the triangle that it lies on.
Varyings VolumeVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
    return output;
}

half4 VolumeFragment(Varyings input) : SV_Target
{
    return 0.0;
}

// The mesh is in clip space, and no matrix moves it.
Varyings PictureVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    output.positionCS = float4(input.positionOS.xy, UNITY_NEAR_CLIP_VALUE, 1.0);
    return output;
}

half4 PictureFragment(Varyings input) : SV_Target
{
    return _ShadowColor;
}

#endif
