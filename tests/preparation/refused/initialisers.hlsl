// initialisers.hlsl:12:21: error: 'k' holds 2 numbers, and its initialiser has 3; give it one value for each, or cast one to the whole type
// initialisers.hlsl:13:8: warning: shaders do not read strings: this variable has no effect
// initialisers.hlsl:16:12: error: 'a' holds 3 numbers, and its initialiser has 2; give it one value for each, or cast one to the whole type
// initialisers.hlsl:17:11: error: 'b' holds 2 numbers, and its initialiser has 3; give it one value for each, or cast one to the whole type
// initialisers.hlsl:18:11: error: 'c' holds 4 numbers, and its initialiser has 3; give it one value for each, or cast one to the whole type
// initialisers.hlsl:19:7: error: 's' holds 3 numbers, and its initialiser has 2; give it one value for each, or cast one to the whole type
// initialisers.hlsl:20:12: error: 'd' holds 2 numbers, and its initialiser has at least 3; give it one value for each, or cast one to the whole type
// initialisers.hlsl:21:11: error: 'e' holds 1 number, and its initialiser has 2; give it one value for each, or cast one to the whole type
// initialisers.hlsl:22:12: warning: shaders do not read strings: this variable has no effect
// initialisers.hlsl:22:28: warning: shaders do not read strings: this variable has no effect
struct S { float a; float2 b; };
static const float2 k = {1, 2, 3};
string text = "a";
float4 Main(float4 p : SV_Position) : SV_Target
{
    float3 a = {1, 2};
    float b[2] = {1, 2, 3};
    float c[2][2] = {{1, 2}, {3}};
    S s = {1, 2};
    float2 d = {p.x + 1, p.y, p.z * 2};
    float e = {1, -2};
    string t = "a"; string u[2];
    return 1;
}
