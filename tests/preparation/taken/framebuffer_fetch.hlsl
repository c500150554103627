// compile: --stage fragment
// compile: --stage vertex -D VERTEX=1
// A deferred lighting pass has such a text: four attachments by macros, in both stages' text.
#define INPUT_HALF(idx) cbuffer hlslcc_SubpassInput_h_##idx { half4 hlslcc_fbinput_##idx; }
#define INPUT_FLOAT(idx) cbuffer hlslcc_SubpassInput_f_##idx { float4 hlslcc_fbinput_##idx; }
#define INPUT_UINT_MS(idx) cbuffer hlslcc_SubpassInput_U_##idx { uint4 hlslcc_fbinput_##idx[8]; }
#define LOAD(idx, v2f) hlslcc_fbinput_##idx
#define LOAD_MS(idx, sampleIdx, v2f) hlslcc_fbinput_##idx[sampleIdx]
#define GBUFFER0 0
#define GBUFFER3 3
INPUT_HALF(GBUFFER0);
INPUT_FLOAT(GBUFFER3);
INPUT_UINT_MS(2);
float4 Shade(float4 p) { return LOAD(GBUFFER0, p.xy) * LOAD(GBUFFER3, p.xy).x + LOAD_MS(2, 1, p.xy); }
#ifdef VERTEX
float4 Main(float4 p : POSITION) : SV_Position { return p; }
#else
float4 Main(float4 p : SV_Position) : SV_Target { return Shade(p); }
#endif
