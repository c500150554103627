// How finely Cell PCSS filters what it does not decide for tiles.
// Written by `penumbra emit` from Shaders/PenumbraCellPcss.technique.json; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_CELL_PCSS_PARAMETERS_HLSL
#define PENUMBRA_CELL_PCSS_PARAMETERS_HLSL

struct CellPcssParameters
{
    // cells: cells of the shadow map, or fewer, from the middle of a wide penumbra's filter to its edge, 3 to 5
    int filterCells;
};

// Unpacks the uniforms _PenumbraCellPcssParameters0, which the package's C# struct of the same name sets.
CellPcssParameters UnpackCellPcssParameters(float4 packed0)
{
    CellPcssParameters parameters;
    parameters.filterCells = int(packed0.x);
    return parameters;
}

#endif
