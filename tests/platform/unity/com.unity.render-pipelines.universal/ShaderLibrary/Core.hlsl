// Stands in for URP's Core.hlsl, so that the package's own shaders compile and run without Unity: the platform macros,
// the depth direction of the graphics API, and the stereo macros with one eye. Names are Unity's interface (core and
// URP 14 to 17).
#ifndef UNIVERSAL_PIPELINE_CORE_INCLUDED
#define UNIVERSAL_PIPELINE_CORE_INCLUDED

#if !defined(UNITY_REVERSED_Z) && \
    (defined(SHADER_API_D3D11) || defined(SHADER_API_VULKAN) || defined(SHADER_API_METAL))
#define UNITY_REVERSED_Z 1
#endif

#include "Packages/com.penumbra.shadows/ShaderLibrary/Platform/Platform.hlsl"

#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)

#endif
