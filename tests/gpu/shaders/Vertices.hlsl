// Test: triangles from vertex buffers; the fragment's colour is what the vertices say.
struct Vertex
{
    float4 position : POSITION;
    float2 uv : TEXCOORD0;
};

struct Varyings
{
    float4 positionCS : SV_Position;
    float2 uv : TEXCOORD0;
};

Varyings Draw(Vertex input)
{
    Varyings output;
    output.positionCS = input.position;
    output.uv = input.uv;
    return output;
}

float4 Colour(Varyings input) : SV_Target
{
    return float4(input.uv, 0.0, 1.0);
}
