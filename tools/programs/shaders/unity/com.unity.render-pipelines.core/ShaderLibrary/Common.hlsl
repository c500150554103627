// Stands in for the core package's Common.hlsl: the platform macros, and the depth direction of the graphics API.
#ifndef STANDS_IN_FOR_COMMON
#define STANDS_IN_FOR_COMMON

#if !defined(UNITY_REVERSED_Z) && \
    (defined(SHADER_API_D3D11) || defined(SHADER_API_VULKAN) || defined(SHADER_API_METAL))
#define UNITY_REVERSED_Z 1
#endif

#include "Packages/com.penumbra.shadows/ShaderLibrary/Platform/Platform.hlsl"

#include "UnityInstancing.hlsl"

#endif
