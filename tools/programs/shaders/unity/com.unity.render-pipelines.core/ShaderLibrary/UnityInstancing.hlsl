// Stands in for the core package's UnityInstancing.hlsl: both eyes in one draw, by instances that choose the layer of
// the target or by multiview, which the graphics API repeats the draw for. Names are Unity's interface (core 14 to 17).
#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED

#if defined(STEREO_INSTANCING_ON)
#define UNITY_STEREO_INSTANCING_ENABLED
#elif defined(STEREO_MULTIVIEW_ON) && \
    (defined(SHADER_API_GLES3) || defined(SHADER_API_GLCORE) || defined(SHADER_API_VULKAN))
#define UNITY_STEREO_MULTIVIEW_ENABLED
#endif

#if defined(UNITY_STEREO_INSTANCING_ENABLED)

static uint unity_StereoEyeIndex;
#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
#define UNITY_SETUP_INSTANCE_ID(input) unity_StereoEyeIndex = (input).instanceID & 1u
#define UNITY_VERTEX_OUTPUT_STEREO uint eye : SV_RenderTargetArrayIndex;
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) (output).eye = unity_StereoEyeIndex
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = (input).eye

#elif defined(UNITY_STEREO_MULTIVIEW_ENABLED)

#if defined(SHADER_STAGE_VERTEX)
uint unity_StereoEyeIndex; // the editor makes the API's built-in view of it
#else
static uint unity_StereoEyeIndex;
#endif
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_VERTEX_OUTPUT_STEREO float eye : BLENDWEIGHT0;
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) (output).eye = unity_StereoEyeIndex
#if defined(SHADER_STAGE_VERTEX)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#else
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = (uint)(input).eye
#endif

#else

#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)

#endif
#endif
