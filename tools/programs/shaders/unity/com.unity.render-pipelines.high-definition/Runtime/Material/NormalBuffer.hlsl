// Stands in for HDRP's NormalBuffer.hlsl.
#ifndef UNITY_NORMAL_BUFFER_INCLUDED
#define UNITY_NORMAL_BUFFER_INCLUDED

struct NormalData
{
    float3 normalWS;
    float perceptualRoughness;
};

Texture2D _NormalBufferTexture;

void DecodeFromNormalBuffer(uint2 positionSS, out NormalData normalData)
{
    const float4 stored = LOAD_TEXTURE2D_LOD(_NormalBufferTexture, positionSS, 0);
    normalData.normalWS = normalize(stored.xyz * 2.0 - 1.0);
    normalData.perceptualRoughness = stored.w;
}

#endif
