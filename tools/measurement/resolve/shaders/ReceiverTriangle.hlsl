// The triangle that covers the picture, for shadow functions that run as fragment shaders.
//
// Computes:   clip positions of a triangle whose pixels are the picture's; its fragments are ResolveFragment's.
// Inputs:     SV_VertexID 0 to 2.

float4 ReceiverTriangle(uint vertex : SV_VertexID) : SV_Position
{
    return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
