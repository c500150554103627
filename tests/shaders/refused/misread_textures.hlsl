// misread_textures.hlsl:6: error: 'Plain' is read with 3 coordinates and has 2: a texture is passed to a function that takes another kind (an array, where both eyes are drawn at once); declare it as that kind (TEXTURE2D_X)
// misread_textures.hlsl:7: error: 'Plain' is read with 3 coordinates and has 2: a texture is passed to a function that takes another kind (an array, where both eyes are drawn at once); declare it as that kind (TEXTURE2D_X)
// misread_textures.hlsl:8: error: 'Plain' is read with 3 coordinates and has 2: a texture is passed to a function that takes another kind (an array, where both eyes are drawn at once); declare it as that kind (TEXTURE2D_X)
// compile: --stage compute
Texture2D Plain; SamplerState S; RWStructuredBuffer<float> _Out;
float Loaded(Texture2DArray t) { return t.Load(int4(1, 2, 1, 0)).x; }
float Sampled(Texture2DArray t) { return t.SampleLevel(S, float3(0.5, 0.5, 1), 0).x; }
float Gathered(Texture2DArray t) { return t.GatherRed(S, float3(0.5, 0.5, 1)).x; }
[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    _Out[id.x] = Loaded(Plain) + Loaded(Plain);
    _Out[id.y] = Sampled(Plain);
    _Out[id.z] = Gathered(Plain);
}
