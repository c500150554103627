// Test: texels of mip levels, layers and slices, as shaders of each kind of texture read them.
Texture2D<float4> _Mips;
Texture2DArray<float4> _Layers;
Texture3D<float4> _Slices;
SamplerState _Sampler;
StructuredBuffer<float4> _Points; // u, v, third coordinate, mip level
RWStructuredBuffer<float4> _Result;

[numthreads(1, 1, 1)] void OfMips(uint3 id : SV_DispatchThreadID)
{
    _Result[id.x] = _Mips.SampleLevel(_Sampler, _Points[id.x].xy, _Points[id.x].w);
}

[numthreads(1, 1, 1)] void OfLayers(uint3 id : SV_DispatchThreadID)
{
    _Result[id.x] = _Layers.SampleLevel(_Sampler, _Points[id.x].xyz, _Points[id.x].w);
}

[numthreads(1, 1, 1)] void OfSlices(uint3 id : SV_DispatchThreadID)
{
    _Result[id.x] = _Slices.SampleLevel(_Sampler, _Points[id.x].xyz, _Points[id.x].w);
}
