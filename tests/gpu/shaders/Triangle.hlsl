// Test: one triangle from a buffer, its colour from push constants.
struct Look
{
    float4 colour;
};
[[vk::push_constant]] ConstantBuffer<Look> _Look;
StructuredBuffer<float4> _Corners;

float4 Vertex(uint corner : SV_VertexID) : SV_Position
{
    return _Corners[corner];
}

struct Colours
{
    float4 first : SV_Target0;
    float second : SV_Target1;
};

Colours Fragment(float4 position : SV_Position)
{
    Colours colours;
    colours.first = _Look.colour;
    colours.second = position.z;
    return colours;
}
