// array_sizes.hlsl:11:7: error: the array 'a' has no size: write how many elements it has
// array_sizes.hlsl:12:19: error: the array 'b' has no size: write how many elements it has
// array_sizes.hlsl:13:18: error: the array 'c' has no size: write how many elements it has
// array_sizes.hlsl:14:14: error: the array 'd' has more than 65536 elements in one dimension: use a buffer or a texture
// array_sizes.hlsl:15:14: error: the array 'e' has more than 65536 elements in one dimension: use a buffer or a texture
// array_sizes.hlsl:16:14: error: the array 'f' has more than 65536 elements in one dimension: use a buffer or a texture
// array_sizes.hlsl:17:11: error: the array 't' has no size: write how many elements it has
// array_sizes.hlsl:20:11: error: the array 'h' has no size: write how many elements it has
// array_sizes.hlsl:21:11: error: the array 'i' has a negative size
// array_sizes.hlsl:21:18: error: the array 'j' has 0 elements: it needs at least one
float a[];
groupshared float b[];
struct S { float c[]; };
static float d[2][65537];
static float e[2][0x10001];
static float f[2][70000u];
Texture2D t[] : register(t0, space1);
float4 Main() : SV_Target
{
    float h[];
    float i[-2], j[0];
    return 1;
}
