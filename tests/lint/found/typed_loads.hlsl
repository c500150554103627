// typed_loads.hlsl:9:15: warning: '_Colour' is read, and Direct3D 11 promises that only of writable textures and buffers of one float, int or uint: read a copy that is a Texture2D, use a buffer of a struct, or ask SystemInfo.SupportsTypedUAVShaderLoadStoreOnGraphicsFormat first [typed-load]
// typed_loads.hlsl:10:5: warning: '_Colour' is read, and Direct3D 11 promises that only of writable textures and buffers of one float, int or uint: read a copy that is a Texture2D, use a buffer of a struct, or ask SystemInfo.SupportsTypedUAVShaderLoadStoreOnGraphicsFormat first [typed-load]
// typed_loads.hlsl:11:15: warning: '_Two' is read, and Direct3D 11 promises that only of writable textures and buffers of one float, int or uint: read a copy that is a Texture2D, use a buffer of a struct, or ask SystemInfo.SupportsTypedUAVShaderLoadStoreOnGraphicsFormat first [typed-load]
// typed_loads.hlsl:11:28: warning: '_Buffer' is read, and Direct3D 11 promises that only of writable textures and buffers of one float, int or uint: read a copy that is a Texture2D, use a buffer of a struct, or ask SystemInfo.SupportsTypedUAVShaderLoadStoreOnGraphicsFormat first [typed-load]
// compile: --stage compute --entry Reads
RWTexture2D<float4> _Colour; RWTexture3D<half2> _Two; RWBuffer<uint4> _Buffer; RWStructuredBuffer<float> W;
[numthreads(8, 8, 1)] void Reads(uint3 id : SV_DispatchThreadID)
{
    W[id.x] = _Colour[id.xy].x;
    _Colour[id.yx] += 1;
    W[id.y] = _Two[id].x + _Buffer[id.x].y;
}
