// Penumbra: Unity's texture macros, counting.
//
// Computes:   what the plain macros compute, and adds one to penumbraFetchCount for every load, every gather, and every
//             filtered or comparing sample.
// Source:     the macro names are Unity's (com.unity.render-pipelines.core, ShaderLibrary/API).
// Inputs:     two ways in. First of all, before any other include: it brings Platform.hlsl and replaces its sampling
//             macros. Or as an overlay after Unity's API/D3D11.hlsl (or Vulkan, Metal, GLCore): there it replaces Unity's.
// Cost:       -
// Guarantees: every image instruction of a counted shader lies in a function named PenumbraCounted*, so a checker of the
//             compiled module can refuse fetches that went past the macros.
// Use it:     in tests and measurements. Not in a product: samples with automatic level of detail read level 0 here;
//             textures of the harness have one level.
#ifndef PENUMBRA_COUNTING_PLATFORM_HLSL
#define PENUMBRA_COUNTING_PLATFORM_HLSL

#if !defined(UNITY_COMMON_INCLUDED)
#include "Platform/Platform.hlsl"
#endif

static uint penumbraFetchCount = 0;

// Texture2D

float4 PenumbraCountedSample(Texture2D map, SamplerState s, float2 at, float level)
{
    ++penumbraFetchCount;
    return map.SampleLevel(s, at, level);
}

float4 PenumbraCountedSampleGrad(Texture2D map, SamplerState s, float2 at, float2 dpdx, float2 dpdy)
{
    ++penumbraFetchCount;
    return map.SampleGrad(s, at, dpdx, dpdy);
}

float PenumbraCountedSampleShadow(Texture2D map, SamplerComparisonState s, float2 at, float reference)
{
    ++penumbraFetchCount;
    return map.SampleCmpLevelZero(s, at, reference);
}

float4 PenumbraCountedGather(Texture2D map, SamplerState s, float2 at)
{
    ++penumbraFetchCount;
    return map.Gather(s, at);
}

float4 PenumbraCountedGatherRed(Texture2D map, SamplerState s, float2 at)
{
    ++penumbraFetchCount;
    return map.GatherRed(s, at);
}

float4 PenumbraCountedGatherGreen(Texture2D map, SamplerState s, float2 at)
{
    ++penumbraFetchCount;
    return map.GatherGreen(s, at);
}

float4 PenumbraCountedGatherBlue(Texture2D map, SamplerState s, float2 at)
{
    ++penumbraFetchCount;
    return map.GatherBlue(s, at);
}

float4 PenumbraCountedGatherAlpha(Texture2D map, SamplerState s, float2 at)
{
    ++penumbraFetchCount;
    return map.GatherAlpha(s, at);
}

float4 PenumbraCountedLoad(Texture2D map, int2 texel, int level)
{
    ++penumbraFetchCount;
    return map.Load(int3(texel, level));
}

float4 PenumbraCountedLoad(Texture2DMS<float4> map, int2 texel, int sampleIndex)
{
    ++penumbraFetchCount;
    return map.Load(texel, sampleIndex);
}

// Texture2DArray

float4 PenumbraCountedSample(Texture2DArray map, SamplerState s, float3 at, float level)
{
    ++penumbraFetchCount;
    return map.SampleLevel(s, at, level);
}

float4 PenumbraCountedSampleGrad(Texture2DArray map, SamplerState s, float3 at, float2 dpdx, float2 dpdy)
{
    ++penumbraFetchCount;
    return map.SampleGrad(s, at, dpdx, dpdy);
}

float PenumbraCountedSampleShadow(Texture2DArray map, SamplerComparisonState s, float3 at, float reference)
{
    ++penumbraFetchCount;
    return map.SampleCmpLevelZero(s, at, reference);
}

float4 PenumbraCountedGather(Texture2DArray map, SamplerState s, float3 at)
{
    ++penumbraFetchCount;
    return map.Gather(s, at);
}

float4 PenumbraCountedLoad(Texture2DArray map, int2 texel, int index, int level)
{
    ++penumbraFetchCount;
    return map.Load(int4(texel, index, level));
}

float4 PenumbraCountedLoadSample(Texture2DMSArray<float4> map, int2 texel, int index, int sampleIndex)
{
    ++penumbraFetchCount;
    return map.Load(int3(texel, index), sampleIndex);
}

// TextureCube

float4 PenumbraCountedSample(TextureCube map, SamplerState s, float3 at, float level)
{
    ++penumbraFetchCount;
    return map.SampleLevel(s, at, level);
}

float PenumbraCountedSampleShadow(TextureCube map, SamplerComparisonState s, float3 at, float reference)
{
    ++penumbraFetchCount;
    return map.SampleCmpLevelZero(s, at, reference);
}

float4 PenumbraCountedGather(TextureCube map, SamplerState s, float3 at)
{
    ++penumbraFetchCount;
    return map.Gather(s, at);
}

// TextureCubeArray

float4 PenumbraCountedSample(TextureCubeArray map, SamplerState s, float4 at, float level)
{
    ++penumbraFetchCount;
    return map.SampleLevel(s, at, level);
}

float PenumbraCountedSampleShadow(TextureCubeArray map, SamplerComparisonState s, float4 at, float reference)
{
    ++penumbraFetchCount;
    return map.SampleCmpLevelZero(s, at, reference);
}

float4 PenumbraCountedGather(TextureCubeArray map, SamplerState s, float4 at)
{
    ++penumbraFetchCount;
    return map.Gather(s, at);
}

// Texture3D

float4 PenumbraCountedSample(Texture3D map, SamplerState s, float3 at, float level)
{
    ++penumbraFetchCount;
    return map.SampleLevel(s, at, level);
}

float4 PenumbraCountedLoad(Texture3D map, int3 texel, int level)
{
    ++penumbraFetchCount;
    return map.Load(int4(texel, level));
}

#endif

// Outside the guard: an overlay replaces whatever stands now.

#undef PLATFORM_SAMPLE_TEXTURE2D
#define PLATFORM_SAMPLE_TEXTURE2D(textureName, samplerName, coord2) \
    PenumbraCountedSample(textureName, samplerName, coord2, 0.0)
#undef SAMPLE_TEXTURE2D
#define SAMPLE_TEXTURE2D(textureName, samplerName, coord2) \
    PenumbraCountedSample(textureName, samplerName, coord2, 0.0)
#undef PLATFORM_SAMPLE_TEXTURE2D_LOD
#define PLATFORM_SAMPLE_TEXTURE2D_LOD(textureName, samplerName, coord2, lod) \
    PenumbraCountedSample(textureName, samplerName, coord2, lod)
#undef SAMPLE_TEXTURE2D_LOD
#define SAMPLE_TEXTURE2D_LOD(textureName, samplerName, coord2, lod) \
    PenumbraCountedSample(textureName, samplerName, coord2, lod)
#undef PLATFORM_SAMPLE_TEXTURE2D_BIAS
#define PLATFORM_SAMPLE_TEXTURE2D_BIAS(textureName, samplerName, coord2, bias) \
    PenumbraCountedSample(textureName, samplerName, coord2, 0.0)
#undef SAMPLE_TEXTURE2D_BIAS
#define SAMPLE_TEXTURE2D_BIAS(textureName, samplerName, coord2, bias) \
    PenumbraCountedSample(textureName, samplerName, coord2, 0.0)
#undef PLATFORM_SAMPLE_TEXTURE2D_GRAD
#define PLATFORM_SAMPLE_TEXTURE2D_GRAD(textureName, samplerName, coord2, dpdx, dpdy) \
    PenumbraCountedSampleGrad(textureName, samplerName, coord2, dpdx, dpdy)
#undef SAMPLE_TEXTURE2D_GRAD
#define SAMPLE_TEXTURE2D_GRAD(textureName, samplerName, coord2, dpdx, dpdy) \
    PenumbraCountedSampleGrad(textureName, samplerName, coord2, dpdx, dpdy)
#undef SAMPLE_TEXTURE2D_SHADOW
#define SAMPLE_TEXTURE2D_SHADOW(textureName, samplerName, coord3) \
    PenumbraCountedSampleShadow(textureName, samplerName, (coord3).xy, (coord3).z)
#undef GATHER_TEXTURE2D
#define GATHER_TEXTURE2D(textureName, samplerName, coord2) PenumbraCountedGather(textureName, samplerName, coord2)
#undef GATHER_RED_TEXTURE2D
#define GATHER_RED_TEXTURE2D(textureName, samplerName, coord2) \
    PenumbraCountedGatherRed(textureName, samplerName, coord2)
#undef GATHER_GREEN_TEXTURE2D
#define GATHER_GREEN_TEXTURE2D(textureName, samplerName, coord2) \
    PenumbraCountedGatherGreen(textureName, samplerName, coord2)
#undef GATHER_BLUE_TEXTURE2D
#define GATHER_BLUE_TEXTURE2D(textureName, samplerName, coord2) \
    PenumbraCountedGatherBlue(textureName, samplerName, coord2)
#undef GATHER_ALPHA_TEXTURE2D
#define GATHER_ALPHA_TEXTURE2D(textureName, samplerName, coord2) \
    PenumbraCountedGatherAlpha(textureName, samplerName, coord2)
#undef LOAD_TEXTURE2D
#define LOAD_TEXTURE2D(textureName, unCoord2) PenumbraCountedLoad(textureName, int2(unCoord2), 0)
#undef LOAD_TEXTURE2D_LOD
#define LOAD_TEXTURE2D_LOD(textureName, unCoord2, lod) PenumbraCountedLoad(textureName, int2(unCoord2), int(lod))
#undef SAMPLE_DEPTH_TEXTURE
#define SAMPLE_DEPTH_TEXTURE(textureName, samplerName, coord2) \
    PenumbraCountedSample(textureName, samplerName, coord2, 0.0).r
#undef SAMPLE_DEPTH_TEXTURE_LOD
#define SAMPLE_DEPTH_TEXTURE_LOD(textureName, samplerName, coord2, lod) \
    PenumbraCountedSample(textureName, samplerName, coord2, lod).r
#undef LOAD_TEXTURE2D_MSAA
#define LOAD_TEXTURE2D_MSAA(textureName, unCoord2, sampleIndex) \
    PenumbraCountedLoad(textureName, int2(unCoord2), int(sampleIndex))
#undef PLATFORM_SAMPLE_TEXTURE2D_ARRAY
#define PLATFORM_SAMPLE_TEXTURE2D_ARRAY(textureName, samplerName, coord2, index) \
    PenumbraCountedSample(textureName, samplerName, float3(coord2, index), 0.0)
#undef SAMPLE_TEXTURE2D_ARRAY
#define SAMPLE_TEXTURE2D_ARRAY(textureName, samplerName, coord2, index) \
    PenumbraCountedSample(textureName, samplerName, float3(coord2, index), 0.0)
#undef PLATFORM_SAMPLE_TEXTURE2D_ARRAY_LOD
#define PLATFORM_SAMPLE_TEXTURE2D_ARRAY_LOD(textureName, samplerName, coord2, index, lod) \
    PenumbraCountedSample(textureName, samplerName, float3(coord2, index), lod)
#undef SAMPLE_TEXTURE2D_ARRAY_LOD
#define SAMPLE_TEXTURE2D_ARRAY_LOD(textureName, samplerName, coord2, index, lod) \
    PenumbraCountedSample(textureName, samplerName, float3(coord2, index), lod)
#undef PLATFORM_SAMPLE_TEXTURE2D_ARRAY_BIAS
#define PLATFORM_SAMPLE_TEXTURE2D_ARRAY_BIAS(textureName, samplerName, coord2, index, bias) \
    PenumbraCountedSample(textureName, samplerName, float3(coord2, index), 0.0)
#undef SAMPLE_TEXTURE2D_ARRAY_BIAS
#define SAMPLE_TEXTURE2D_ARRAY_BIAS(textureName, samplerName, coord2, index, bias) \
    PenumbraCountedSample(textureName, samplerName, float3(coord2, index), 0.0)
#undef PLATFORM_SAMPLE_TEXTURE2D_ARRAY_GRAD
#define PLATFORM_SAMPLE_TEXTURE2D_ARRAY_GRAD(textureName, samplerName, coord2, index, dpdx, dpdy) \
    PenumbraCountedSampleGrad(textureName, samplerName, float3(coord2, index), dpdx, dpdy)
#undef SAMPLE_TEXTURE2D_ARRAY_GRAD
#define SAMPLE_TEXTURE2D_ARRAY_GRAD(textureName, samplerName, coord2, index, dpdx, dpdy) \
    PenumbraCountedSampleGrad(textureName, samplerName, float3(coord2, index), dpdx, dpdy)
#undef SAMPLE_TEXTURE2D_ARRAY_SHADOW
#define SAMPLE_TEXTURE2D_ARRAY_SHADOW(textureName, samplerName, coord3, index) \
    PenumbraCountedSampleShadow(textureName, samplerName, float3((coord3).xy, index), (coord3).z)
#undef GATHER_TEXTURE2D_ARRAY
#define GATHER_TEXTURE2D_ARRAY(textureName, samplerName, coord2, index) \
    PenumbraCountedGather(textureName, samplerName, float3(coord2, index))
#undef LOAD_TEXTURE2D_ARRAY
#define LOAD_TEXTURE2D_ARRAY(textureName, unCoord2, index) \
    PenumbraCountedLoad(textureName, int2(unCoord2), int(index), 0)
#undef LOAD_TEXTURE2D_ARRAY_LOD
#define LOAD_TEXTURE2D_ARRAY_LOD(textureName, unCoord2, index, lod) \
    PenumbraCountedLoad(textureName, int2(unCoord2), int(index), int(lod))
#undef LOAD_TEXTURE2D_ARRAY_MSAA
#define LOAD_TEXTURE2D_ARRAY_MSAA(textureName, unCoord2, index, sampleIndex) \
    PenumbraCountedLoadSample(textureName, int2(unCoord2), int(index), int(sampleIndex))
#undef PLATFORM_SAMPLE_TEXTURECUBE
#define PLATFORM_SAMPLE_TEXTURECUBE(textureName, samplerName, coord3) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef SAMPLE_TEXTURECUBE
#define SAMPLE_TEXTURECUBE(textureName, samplerName, coord3) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef PLATFORM_SAMPLE_TEXTURECUBE_LOD
#define PLATFORM_SAMPLE_TEXTURECUBE_LOD(textureName, samplerName, coord3, lod) \
    PenumbraCountedSample(textureName, samplerName, coord3, lod)
#undef SAMPLE_TEXTURECUBE_LOD
#define SAMPLE_TEXTURECUBE_LOD(textureName, samplerName, coord3, lod) \
    PenumbraCountedSample(textureName, samplerName, coord3, lod)
#undef PLATFORM_SAMPLE_TEXTURECUBE_BIAS
#define PLATFORM_SAMPLE_TEXTURECUBE_BIAS(textureName, samplerName, coord3, bias) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef SAMPLE_TEXTURECUBE_BIAS
#define SAMPLE_TEXTURECUBE_BIAS(textureName, samplerName, coord3, bias) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef SAMPLE_TEXTURECUBE_SHADOW
#define SAMPLE_TEXTURECUBE_SHADOW(textureName, samplerName, coord4) \
    PenumbraCountedSampleShadow(textureName, samplerName, (coord4).xyz, (coord4).w)
#undef GATHER_TEXTURECUBE
#define GATHER_TEXTURECUBE(textureName, samplerName, coord3) PenumbraCountedGather(textureName, samplerName, coord3)
#undef PLATFORM_SAMPLE_TEXTURECUBE_ARRAY
#define PLATFORM_SAMPLE_TEXTURECUBE_ARRAY(textureName, samplerName, coord3, index) \
    PenumbraCountedSample(textureName, samplerName, float4(coord3, index), 0.0)
#undef SAMPLE_TEXTURECUBE_ARRAY
#define SAMPLE_TEXTURECUBE_ARRAY(textureName, samplerName, coord3, index) \
    PenumbraCountedSample(textureName, samplerName, float4(coord3, index), 0.0)
#undef PLATFORM_SAMPLE_TEXTURECUBE_ARRAY_LOD
#define PLATFORM_SAMPLE_TEXTURECUBE_ARRAY_LOD(textureName, samplerName, coord3, index, lod) \
    PenumbraCountedSample(textureName, samplerName, float4(coord3, index), lod)
#undef SAMPLE_TEXTURECUBE_ARRAY_LOD
#define SAMPLE_TEXTURECUBE_ARRAY_LOD(textureName, samplerName, coord3, index, lod) \
    PenumbraCountedSample(textureName, samplerName, float4(coord3, index), lod)
#undef PLATFORM_SAMPLE_TEXTURECUBE_ARRAY_BIAS
#define PLATFORM_SAMPLE_TEXTURECUBE_ARRAY_BIAS(textureName, samplerName, coord3, index, bias) \
    PenumbraCountedSample(textureName, samplerName, float4(coord3, index), 0.0)
#undef SAMPLE_TEXTURECUBE_ARRAY_BIAS
#define SAMPLE_TEXTURECUBE_ARRAY_BIAS(textureName, samplerName, coord3, index, bias) \
    PenumbraCountedSample(textureName, samplerName, float4(coord3, index), 0.0)
#undef SAMPLE_TEXTURECUBE_ARRAY_SHADOW
#define SAMPLE_TEXTURECUBE_ARRAY_SHADOW(textureName, samplerName, coord4, index) \
    PenumbraCountedSampleShadow(textureName, samplerName, float4((coord4).xyz, index), (coord4).w)
#undef GATHER_TEXTURECUBE_ARRAY
#define GATHER_TEXTURECUBE_ARRAY(textureName, samplerName, coord3, index) \
    PenumbraCountedGather(textureName, samplerName, float4(coord3, index))
#undef PLATFORM_SAMPLE_TEXTURE3D
#define PLATFORM_SAMPLE_TEXTURE3D(textureName, samplerName, coord3) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef SAMPLE_TEXTURE3D
#define SAMPLE_TEXTURE3D(textureName, samplerName, coord3) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef PLATFORM_SAMPLE_TEXTURE3D_LOD
#define PLATFORM_SAMPLE_TEXTURE3D_LOD(textureName, samplerName, coord3, lod) \
    PenumbraCountedSample(textureName, samplerName, coord3, lod)
#undef SAMPLE_TEXTURE3D_LOD
#define SAMPLE_TEXTURE3D_LOD(textureName, samplerName, coord3, lod) \
    PenumbraCountedSample(textureName, samplerName, coord3, lod)
#undef PLATFORM_SAMPLE_TEXTURE3D_BIAS
#define PLATFORM_SAMPLE_TEXTURE3D_BIAS(textureName, samplerName, coord3, bias) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef SAMPLE_TEXTURE3D_BIAS
#define SAMPLE_TEXTURE3D_BIAS(textureName, samplerName, coord3, bias) \
    PenumbraCountedSample(textureName, samplerName, coord3, 0.0)
#undef LOAD_TEXTURE3D
#define LOAD_TEXTURE3D(textureName, unCoord3) PenumbraCountedLoad(textureName, int3(unCoord3), 0)
#undef LOAD_TEXTURE3D_LOD
#define LOAD_TEXTURE3D_LOD(textureName, unCoord3, lod) PenumbraCountedLoad(textureName, int3(unCoord3), int(lod))
