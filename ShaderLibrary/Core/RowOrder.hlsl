// Penumbra: places of a grid by an index that counts along its rows.
//
// Computes:   the column and row of an index.
//
//                 0 1 2        of a grid 3 wide, index 4 is at column 1 of row 1
//                 3 4 5
//
// Source:     division with remainder, of unsigned integers: Direct3D's bytecode has an instruction for these alone.
// Inputs:     index from 0; width from 1.
// Cost:       no fetches.
// Guarantees: exact.
// Use it:     where threads or a loop go through a grid.
#ifndef PENUMBRA_ROW_ORDER_HLSL
#define PENUMBRA_ROW_ORDER_HLSL

int2 PlaceInRows(int index, int width)
{
    return int2(uint(index) % uint(width), uint(index) / uint(width));
}

#endif
