// packoffsets.hlsl:7:21: error: the packoffset of 'a' leaves room for 1 of its 2 components in its register, and a vector must not straddle two: begin at an earlier component
// packoffsets.hlsl:8:23: error: the packoffset of 'b' is not the beginning of a register, which matrices, arrays and structs need: write it without the component, or with .x
// packoffsets.hlsl:9:20: error: the packoffset of 'c' is not the beginning of a register, which matrices, arrays and structs need: write it without the component, or with .x
// packoffsets.hlsl:10:47: error: the packoffset of 'e' lies in 'd': give them offsets that do not overlap
// packoffsets.hlsl:11:76: error: the packoffset of 'h' lies in 'f': give them offsets that do not overlap
// packoffsets.hlsl:12:12: error: packoffset is for members of a cbuffer, and this variable is in none: remove it
cbuffer C1 { float2 a : packoffset(c0.w); };
cbuffer C2 { float4x4 b : packoffset(c0.y); };
cbuffer C3 { float c[2] : packoffset(c0.z); };
cbuffer C4 { float4 d : packoffset(c0); float e : packoffset(c0.y); }
cbuffer C5 { float3x3 f : packoffset(c1); float g : packoffset(c4); float4 h[2] : packoffset(c0); }
float4 k : packoffset(c0);
float4 Main() : SV_Target { return 1; }
