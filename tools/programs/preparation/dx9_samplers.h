// Samplers of Direct3D 9, which are a texture and a sampler in one: sampler1D, sampler2D, sampler3D,
// samplerCUBE, `sampler` where it is read by tex2D and its like, and those functions themselves
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-tex2d and its neighbours). glslang reads
// some of them and makes a module that no Vulkan driver takes; others it refuses.
//
// `sampler2D _MainTex;` becomes `Texture2D _MainTex; SamplerState sampler_MainTex;`, the names Unity's own
// macros use. Wherever the old one was a whole argument - of tex2D, of a function, in a prototype, as a
// member or an element of an array - the two stand side by side; `a = b` becomes both assignments. What reads
// them is defined once at the head of the text, under its old name, as the documentation has it: tex2Dlod(s,
// c) is t.SampleLevel(s, c.xy, c.w), tex2Dbias the same with SampleBias, tex2Dproj divides by c.w, tex2Dgrad
// and tex2D with four arguments are SampleGrad. As functions they convert what is passed as the old ones do,
// and evaluate it once. register(s1) becomes register(t1) for the texture and stays for the sampler; sampler
// states that are written in the shader have no effect in Unity and go.
//
// Limits: a `sampler` is what the function that reads it says; one read as two kinds is an error. A sampler
// that is returned or chosen with ?: is an error. An index is evaluated twice.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void separate_dx9_samplers(TokenText& text);

}  // namespace penumbra::preparation
