// Core functions, of which one macro makes half and float twins.
#ifndef UNITY_COMMON_INCLUDED
#define UNITY_COMMON_INCLUDED
#define real float
#include "Packages/test.core/ShaderLibrary/API/Vulkan.hlsl"
#define TWINS(type) type Mean3(type a, type b, type c) { return (a + b + c) / type(3.0); }
TWINS(half)
TWINS(float)
#endif
