// Stands in for URP's Shadows.hlsl.
#include "UrpGlobals.hlsl"
