// Direct3D 9 samplers, which combine a texture and a sampler: sampler1D, sampler2D, sampler3D, samplerCUBE,
// `sampler` where tex2D or a similar function reads it, and these functions
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-tex2d and the pages beside it). For some
// of them glslang produces a module that no Vulkan driver accepts; others it rejects.
//
// `sampler2D _MainTex;` becomes `Texture2D _MainTex; SamplerState sampler_MainTex;`, the names that Unity's
// own macros use. Wherever the sampler was a whole argument of tex2D, of a function or of a prototype, a
// member, or an array element, the pair replaces it; `a = b` becomes both assignments. The functions are
// defined once at the beginning of the text under their names, as documented: tex2Dlod(s, c) is
// t.SampleLevel(s, c.xy, c.w), tex2Dbias the same with SampleBias, tex2Dproj divides by c.w, tex2Dgrad and
// tex2D with four arguments are SampleGrad. As functions, they convert arguments as the built-in ones do, and
// evaluate them once. register(s1) becomes register(t1) for the texture and stays for the sampler; sampler
// states in the shader have no effect in Unity and are removed.
//
// Limits: the kind of a `sampler` follows from the functions that read it; a sampler read as two kinds is an
// error. A sampler that is returned or selected by ?: is an error. An index is evaluated twice.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void separate_dx9_samplers(TokenText& text);

}  // namespace penumbra::preparation
