// base_struct_levels.hlsl:19:8: error: 'S17' has more than 16 levels of base structs
struct S0 { int a; };
struct S1 : S0 { int b1; };
struct S2 : S1 { int b2; };
struct S3 : S2 { int b3; };
struct S4 : S3 { int b4; };
struct S5 : S4 { int b5; };
struct S6 : S5 { int b6; };
struct S7 : S6 { int b7; };
struct S8 : S7 { int b8; };
struct S9 : S8 { int b9; };
struct S10 : S9 { int b10; };
struct S11 : S10 { int b11; };
struct S12 : S11 { int b12; };
struct S13 : S12 { int b13; };
struct S14 : S13 { int b14; };
struct S15 : S14 { int b15; };
struct S16 : S15 { int b16; };
struct S17 : S16 { int b17; };
float4 Main() : SV_Target { return 1; }
