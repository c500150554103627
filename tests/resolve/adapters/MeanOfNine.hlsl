// An adapter for the small pipeline of this folder.
#include "Packages/test.pipeline/ShaderLibrary/Shadows.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return MeanOfNine(positionWS); }
