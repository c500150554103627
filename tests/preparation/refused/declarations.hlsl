// declarations.hlsl:17:1: error: expected ';' before 'float _B'
// declarations.hlsl:18:10: error: expected ',' or ';' before '_D'
// declarations.hlsl:19:24: error: expected ';' before 'uint b'
// declarations.hlsl:20:21: error: expected ';' behind this '}' of a struct
// declarations.hlsl:26:5: error: expected ';' before 'float d'
// declarations.hlsl:28:5: error: expected ';' before 'int f'
// declarations.hlsl:30:5: error: expected ';' before 'half h'
// declarations.hlsl:32:5: error: expected ';' before 'bool k'
// declarations.hlsl:33:15: error: expected ',' or ';' before 'm'
// declarations.hlsl:35:17: error: expected ',' or ';' before 'z'
// declarations.hlsl:36:17: error: expected ',' or ';' before 'bogus'
// declarations.hlsl:37:27: error: expected ',' or ';' before 'q'
// declarations.hlsl:38:23: error: expected ',' or ';' before 's'
// declarations.hlsl:39:24: error: expected ',' or ';' before '2'
// The front end takes many of these without a word.
float _A
float _B;
float _C _D;
struct S { float a : A uint b : B; };
struct T { float a; }
float F(float x) { return x; }
float4 Main(float4 p : SV_Position) : SV_Target
{
    int n = 1;
    float c = 1
    float d = 2;
    int e = n
    int f = 2;
    float g = sin(p.x)
    half h = 2;
    float i[2] = { 1, 2 }; float j = i[1]
    bool k = true;
    int l = 3 m = 4;
    float x, z;
    float y = x z;
    float o = 1 bogus;
    int q; for (int r = 0 q; r < 3; ++r) { }
    float s, t = F(1) s;
    S u; float v = u.a 2;
    return 1;
}
