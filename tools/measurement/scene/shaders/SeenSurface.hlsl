// Penumbra tools: which surface the camera sees at each pixel centre.
//
// Computes:   the point seen, relative to the scene's origin, and the number of its triangle.
// Inputs:     _ViewRow0..2: rows of the matrix from the mesh's space to (clip x, clip y, view depth), metres and
//             tangents, clip y = -1 at the top; _NearPlane: metres, x.
// Cost:       no texture fetches; with PENUMBRA_CUT_OUTS CutOut.hlsl's.
// Guarantees: w of the result is 0 only where nothing is seen (the clear value): triangle t is written as the float
//             whose bits are 0x40000000 + t, never a NaN or denormal for t < 2^29. Where a surface is cut out, what is
//             behind it is seen.
// Use it:     by the rasteriser (tools/measurement/scene).
#include "SceneMesh.hlsl"
#if PENUMBRA_CUT_OUTS
#include "CutOut.hlsl"
#endif

struct CameraView
{
    float4 viewRow0;
    float4 viewRow1;
    float4 viewRow2;
    float4 nearPlane;
};
[[vk::push_constant]] ConstantBuffer<CameraView> _View;

struct Seen
{
    float4 positionCS : SV_Position;
    float3 position : POSITION0;
    nointerpolation uint triangleNumber : TEXCOORD0;
#if PENUMBRA_CUT_OUTS
    float2 uv : TEXCOORD1;
#endif
};

Seen Vertex(uint corner : SV_VertexID)
{
    Seen seen;
    seen.position = CornerPosition(corner);
    seen.triangleNumber = corner / 3;
#if PENUMBRA_CUT_OUTS
    seen.uv = CornerTexCoord(corner);
#endif
    const float4 homogeneous = float4(seen.position, 1.0);
    // Reversed depth without a far plane: near / distance, which floats resolve evenly.
    seen.positionCS = float4(dot(_View.viewRow0, homogeneous), dot(_View.viewRow1, homogeneous), _View.nearPlane.x,
                             dot(_View.viewRow2, homogeneous));
    return seen;
}

float4 Fragment(Seen seen) : SV_Target0
{
#if PENUMBRA_CUT_OUTS
    if (IsOpen(seen.triangleNumber, seen.uv))
        discard;
#endif
    return float4(seen.position, asfloat(0x40000000u + seen.triangleNumber));
}
