// lost_texture.hlsl:5: error: a texture is read uninitialised; if every path does initialise it, one function reads it both with a comparison sampler and with another sampler, which glslang miscompiles: use a separate function for each
float4 Main(float4 p : SV_Position) : SV_Target
{
    Texture2D t;
    return t.Load(0);
}
