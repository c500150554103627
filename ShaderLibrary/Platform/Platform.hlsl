// Penumbra: texture, sampler and flow-control macros for use outside Unity.
//
// Computes:   nothing. Defines the macro names of Unity's core ShaderLibrary as they are on Direct3D 11, Vulkan and
//             Metal, so that all other files of this library are the same inside and outside Unity.
// Source:     the names are Unity's public interface (com.unity.render-pipelines.core); the definitions follow
//             from HLSL's texture objects.
// Inputs:     UNITY_COMMON_INCLUDED: Unity's own macros are defined, and this file does nothing.
//             PENUMBRA_PLATFORM_INCLUDED: other macros are (an engine's own).
// Cost:       none.
// Guarantees: a filter that reaches textures through these names only can be ported.
// Use it:     include it first when calling Filters/ from your own engine. Not: inside Unity, where Core.hlsl
//             of the pipeline comes first.
#ifndef PENUMBRA_PLATFORM_HLSL
#define PENUMBRA_PLATFORM_HLSL

#if !defined(UNITY_COMMON_INCLUDED) && !defined(PENUMBRA_PLATFORM_INCLUDED)
#define PENUMBRA_PLATFORM_INCLUDED

// 16-bit arithmetic is a Unity setting; outside Unity `real` is float.
#define real float
#define real2 float2
#define real3 float3
#define real4 float4

#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };

#define UNITY_BRANCH [branch]
#define UNITY_FLATTEN [flatten]
#define UNITY_UNROLL [unroll]
#define UNITY_LOOP [loop]

#define TEXTURE2D(textureName) Texture2D textureName
#define TEXTURE2D_SHADOW(textureName) TEXTURE2D(textureName)
#define TEXTURE3D(textureName) Texture3D textureName
#define SAMPLER(samplerName) SamplerState samplerName
#define SAMPLER_CMP(samplerName) SamplerComparisonState samplerName

#define TEXTURE2D_PARAM(textureName, samplerName) TEXTURE2D(textureName), SAMPLER(samplerName)
#define TEXTURE2D_ARGS(textureName, samplerName) textureName, samplerName
#define TEXTURE3D_ARGS(textureName, samplerName) textureName, samplerName
#define TEXTURE2D_SHADOW_PARAM(textureName, samplerName) TEXTURE2D(textureName), SAMPLER_CMP(samplerName)
#define TEXTURE2D_SHADOW_ARGS(textureName, samplerName) textureName, samplerName

#define SAMPLE_TEXTURE2D(textureName, samplerName, uv) textureName.Sample(samplerName, uv)
#define SAMPLE_TEXTURE2D_LOD(textureName, samplerName, uv, lod) textureName.SampleLevel(samplerName, uv, lod)
#define SAMPLE_TEXTURE3D_LOD(textureName, samplerName, uvw, lod) textureName.SampleLevel(samplerName, uvw, lod)
#define SAMPLE_TEXTURE2D_SHADOW(textureName, samplerName, uvAndDepth) \
    textureName.SampleCmpLevelZero(samplerName, (uvAndDepth).xy, (uvAndDepth).z)
#define LOAD_TEXTURE2D(textureName, texel) textureName.Load(int3(texel, 0))
#define LOAD_TEXTURE2D_LOD(textureName, texel, lod) textureName.Load(int3(texel, lod))
#define GATHER_RED_TEXTURE2D(textureName, samplerName, uv) textureName.GatherRed(samplerName, uv)

// Screen-sized textures: Unity makes them arrays when both eyes are drawn at once.
#define SLICE_ARRAY_INDEX 0
#define TEXTURE2D_X(textureName) TEXTURE2D(textureName)
#define TEXTURE2D_X_FLOAT(textureName) TEXTURE2D(textureName)
#define LOAD_TEXTURE2D_X(textureName, texel) LOAD_TEXTURE2D(textureName, texel)
#define GATHER_RED_TEXTURE2D_X(textureName, samplerName, uv) GATHER_RED_TEXTURE2D(textureName, samplerName, uv)

#endif

// Unity's core package has not all of these for multisampled textures. Textures of integers are declared as
// Texture2D<uint4>: the core package's TYPED_TEXTURE2D, from version 17 on, is an error on OpenGL wherever
// SHADER_AVAILABLE_RANDOMWRITE is not defined.
#if defined(UNITY_STEREO_INSTANCING_ENABLED) || defined(UNITY_STEREO_MULTIVIEW_ENABLED)
#if !defined(TEXTURE2D_X_MSAA)
#define TEXTURE2D_X_MSAA(type, textureName) Texture2DMSArray<type> textureName
#endif
#if !defined(LOAD_TEXTURE2D_X_MSAA)
#define LOAD_TEXTURE2D_X_MSAA(textureName, texel, sampleIndex) textureName.Load(int3(texel, SLICE_ARRAY_INDEX), sampleIndex)
#endif
#else
#if !defined(TEXTURE2D_X_MSAA)
#define TEXTURE2D_X_MSAA(type, textureName) Texture2DMS<type> textureName
#endif
#if !defined(LOAD_TEXTURE2D_X_MSAA)
#define LOAD_TEXTURE2D_X_MSAA(textureName, texel, sampleIndex) textureName.Load(texel, sampleIndex)
#endif
#endif
#endif
