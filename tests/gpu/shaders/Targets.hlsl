// Test: what fragment shaders write into targets of several kinds.
struct Look
{
    float4 colour;
};
[[vk::push_constant]] ConstantBuffer<Look> _Look;

// The three corners of a triangle over all of the target, or over its left half along the diagonal.
float4 Whole(uint corner : SV_VertexID) : SV_Position
{
    return float4(corner == 1 ? 3 : -1, corner == 2 ? 3 : -1, 0.5, 1);
}

float4 BelowDiagonal(uint corner : SV_VertexID) : SV_Position
{
    return float4(corner == 1 ? 1 : -1, corner == 2 ? 1 : -1, 0.5, 1);
}

float4 Plain() : SV_Target
{
    return _Look.colour;
}

float4 SampleNumber(uint sample_number : SV_SampleIndex) : SV_Target
{
    return sample_number;
}

uint4 Integers(float4 position : SV_Position) : SV_Target
{
    return uint4(position.x, position.y, 4000000000u, 1);
}

struct FourColours
{
    float4 first : SV_Target0;
    float4 second : SV_Target1;
    float4 third : SV_Target2;
    float4 fourth : SV_Target3;
};

FourColours Four()
{
    FourColours colours;
    colours.first = _Look.colour;
    colours.second = 2 * _Look.colour;
    colours.third = 3 * _Look.colour;
    colours.fourth = 4 * _Look.colour;
    return colours;
}

Texture2D<float4> _Vertices;

// Both stages read textures, which number their bindings each for itself.
float4 FromTexture(uint corner : SV_VertexID) : SV_Position
{
    return _Vertices.Load(int3(corner, 0, 0));
}

Texture2D<float4> _Colours;

float4 OfTexture(float4 position : SV_Position) : SV_Target
{
    return _Colours.Load(int3(0, 0, 0));
}
