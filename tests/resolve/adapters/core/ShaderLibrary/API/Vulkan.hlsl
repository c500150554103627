// The macros of one graphics API, in the place where a pipeline keeps them.
#define TEXTURE2D_SHADOW(textureName) Texture2D textureName
#define SAMPLER_CMP(samplerName) SamplerComparisonState samplerName
#define TEXTURE2D_SHADOW_PARAM(textureName, samplerName) Texture2D textureName, SamplerComparisonState samplerName
#define TEXTURE2D_SHADOW_ARGS(textureName, samplerName) textureName, samplerName
#define SAMPLE_TEXTURE2D_SHADOW(textureName, samplerName, coord3) \
    textureName.SampleCmpLevelZero(samplerName, (coord3).xy, (coord3).z)
