// Stands in for URP's Core.hlsl, so that the package's own shaders compile and run without Unity: the platform macros,
// the depth direction of the graphics API, and the textures of the screen for one eye or both. Names are Unity's
// interface (core and URP 14 to 17).
#ifndef UNIVERSAL_PIPELINE_CORE_INCLUDED
#define UNIVERSAL_PIPELINE_CORE_INCLUDED

#if !defined(UNITY_REVERSED_Z) && \
    (defined(SHADER_API_D3D11) || defined(SHADER_API_VULKAN) || defined(SHADER_API_METAL))
#define UNITY_REVERSED_Z 1
#endif

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/UnityInstancing.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Platform/Platform.hlsl"

// Unity's API/GLCore.hlsl and API/GLES3.hlsl define no gather below target 4.5, and so a program that names one is an
// error there, even if nothing calls the function that gathers. This file does the same.
#if (defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES3)) && SHADER_TARGET < 45
#undef GATHER_RED_TEXTURE2D
#define GATHER_RED_TEXTURE2D(textureName, samplerName, uv) StandsInHasNoGatherBelowTarget45
#endif

float3 _WorldSpaceCameraPos;

// Of two eyes drawn at once a texture of the screen is an array with a slice for each. By a function, which takes no
// plain texture; Load itself would shorten the coordinate.
#if defined(UNITY_STEREO_INSTANCING_ENABLED) || defined(UNITY_STEREO_MULTIVIEW_ENABLED)
#undef SLICE_ARRAY_INDEX
#undef TEXTURE2D_X
#undef TEXTURE2D_X_FLOAT
#undef LOAD_TEXTURE2D_X
#undef GATHER_RED_TEXTURE2D_X
#define SLICE_ARRAY_INDEX unity_StereoEyeIndex
#define TEXTURE2D_X(textureName) Texture2DArray textureName
#define TEXTURE2D_X_FLOAT(textureName) Texture2DArray textureName
#define LOAD_TEXTURE2D_X(textureName, texel) StandsInLoadOfThisEye(textureName, texel)
#define GATHER_RED_TEXTURE2D_X(textureName, samplerName, uv) \
    GATHER_RED_TEXTURE2D(textureName, samplerName, float3(uv, SLICE_ARRAY_INDEX))

float4 StandsInLoadOfThisEye(Texture2DArray image, int2 texel)
{
    return image.Load(int4(texel, unity_StereoEyeIndex, 0));
}
#endif

float4 _MainLightPosition; // xyz: the unit direction towards a directional light

#endif
