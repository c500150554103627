// Penumbra: means over boxes of any size, from summed-area tables in integers.
//
// Computes:   per channel, the mean of a box of a cascade's tile from the table of its sums.
// Source:     Crow, "Summed-Area Tables for Texture Mapping", 1984; in integers for shadow maps: Lauritzen, GPU Gems 3,
//             section 8.5. A box is four sums,
//
//                  A-------B
//                  |  box  |     D - B - C + A   each of all texels of the tile above and left of it
//                  C-------D
//
//             and all arithmetic is modulo 2^32: what overflows in the sums cancels in their difference, which is exact
//             where the box's own sum is below 2^32. Of values below 2^b that is every box of up to 2^(32 - b) texels.
// Inputs:     sums: of Shaders/SummedAreas.compute, each tile by itself; positions in texel coordinates of the map.
// Cost:       MeanOfTexels: 4 fetches. MeanOfBox: 16.
// Guarantees: nothing outside of the tile is read; a box is cut off at the tile's border, and its mean is that of what
//             is left, by its true area. Channels are rounded once, to float, after they were subtracted.
// Use it:     for kernels whose width differs from pixel to pixel. Not: for one width, for which a blur costs 1 fetch.
#ifndef PENUMBRA_SUMMED_AREA_HLSL
#define PENUMBRA_SUMMED_AREA_HLSL

#include "../Core/TileBounds.hlsl"

// The whole texels in [low, high).
struct TexelBox
{
    int2 low;
    int2 high;
};

// A box with edges between texels.
struct MapBox
{
    float2 low;
    float2 high;
};

// The part inside the tile of a box with its middle at `centre`; at least one texel wide.
MapBox BoxInTile(float2 centre, float halfWidth, TileBounds bounds)
{
    const float2 middle = min(max(centre, bounds.minimum + 0.5), max(bounds.maximum - 0.5, bounds.minimum + 0.5));
    const float reach = max(halfWidth, 0.5);
    MapBox box;
    box.low = max(middle - reach, bounds.minimum);
    box.high = min(max(middle + reach, box.low + 1.0), max(bounds.maximum, bounds.minimum + 1.0));
    box.low = min(box.low, box.high - 1.0);
    return box;
}

float2 MiddleOf(MapBox box)
{
    return 0.5 * (box.low + box.high);
}

// The whole texels nearest to a box; at least one each way.
TexelBox WholeTexels(MapBox box)
{
    TexelBox texels;
    texels.low = int2(floor(box.low + 0.5));
    texels.high = max(int2(floor(box.high + 0.5)), texels.low + 1);
    return texels;
}

MapBox BoxOf(TexelBox texels)
{
    MapBox box;
    box.low = float2(texels.low);
    box.high = float2(texels.high);
    return box;
}

float AreaOf(TexelBox texels)
{
    const float2 size = float2(texels.high - texels.low);
    return size.x * size.y;
}

// The sum of the texels that lie in the tile above and left of `corner`.
uint4 SumBefore(Texture2D<uint4> sums, int2 corner, int2 tileLow)
{
    const uint4 sum = LOAD_TEXTURE2D(sums, max(corner - 1, tileLow));
    return corner.x > tileLow.x && corner.y > tileLow.y ? sum : uint4(0, 0, 0, 0);
}

uint4 SumOfTexels(Texture2D<uint4> sums, TexelBox box, int2 tileLow)
{
    return SumBefore(sums, box.high, tileLow) - SumBefore(sums, int2(box.high.x, box.low.y), tileLow) -
           SumBefore(sums, int2(box.low.x, box.high.y), tileLow) + SumBefore(sums, box.low, tileLow);
}

// The sum of (value - middle) over `texels` texels, in floats: the subtraction is exact, |sum| <= 2^31.
float4 CentredSum(uint4 sum, uint middle, int texels)
{
    return float4(int4(sum - middle * uint(texels)));
}

// The mean of (value - middle).
float4 MeanOfTexels(Texture2D<uint4> sums, TexelBox box, int2 tileLow, uint middle)
{
    const int2 size = box.high - box.low;
    return CentredSum(SumOfTexels(sums, box, tileLow), middle, size.x * size.y) / AreaOf(box);
}

// The cells of a box along one axis: where they begin and end, and how much of each lies in the box. The first and the
// last cell are one texel wide; the one between has the rest, which may be nothing.
struct BoxCells
{
    int4 edges;
    float3 shares;
};

BoxCells CellsOf(float low, float high, float end)
{
    const int first = int(floor(low));
    const int last = max(int(floor(high)), first + 1);
    BoxCells cells;
    cells.edges = int4(first, first + 1, last, min(last + 1, int(end)));
    cells.shares = float3(1.0 - (low - float(first)), 1.0, max(high - float(last), 0.0));
    return cells;
}

struct SumRow
{
    uint4 at[4];
};

SumRow SumsBefore(Texture2D<uint4> sums, int4 x, int y, int2 tileLow)
{
    SumRow row;
    row.at[0] = SumBefore(sums, int2(x.x, y), tileLow);
    row.at[1] = SumBefore(sums, int2(x.y, y), tileLow);
    row.at[2] = SumBefore(sums, int2(x.z, y), tileLow);
    row.at[3] = SumBefore(sums, int2(x.w, y), tileLow);
    return row;
}

// The sum over three cells between two rows, weighted by their shares.
float4 CentredBand(SumRow above, SumRow below, int4 x, float3 shares, int height, uint middle)
{
    uint4 columns[4];
    UNITY_UNROLL
    for (int i = 0; i < 4; ++i) columns[i] = below.at[i] - above.at[i];
    return shares.x * CentredSum(columns[1] - columns[0], middle, (x.y - x.x) * height) +
           shares.y * CentredSum(columns[2] - columns[1], middle, (x.z - x.y) * height) +
           shares.z * CentredSum(columns[3] - columns[2], middle, (x.w - x.z) * height);
}

// The mean of (value - middle); texels at the box's edges count by the share of them that lies in the box.
float4 MeanOfBox(Texture2D<uint4> sums, MapBox box, TileBounds bounds, uint middle)
{
    const int2 tileLow = int2(bounds.minimum);
    const BoxCells x = CellsOf(box.low.x, box.high.x, bounds.maximum.x);
    const BoxCells y = CellsOf(box.low.y, box.high.y, bounds.maximum.y);
    const SumRow row0 = SumsBefore(sums, x.edges, y.edges.x, tileLow);
    const SumRow row1 = SumsBefore(sums, x.edges, y.edges.y, tileLow);
    const SumRow row2 = SumsBefore(sums, x.edges, y.edges.z, tileLow);
    const SumRow row3 = SumsBefore(sums, x.edges, y.edges.w, tileLow);
    const int3 heights = y.edges.yzw - y.edges.xyz;
    const float4 sum = y.shares.x * CentredBand(row0, row1, x.edges, x.shares, heights.x, middle) +
                       y.shares.y * CentredBand(row1, row2, x.edges, x.shares, heights.y, middle) +
                       y.shares.z * CentredBand(row2, row3, x.edges, x.shares, heights.z, middle);
    const float2 size = box.high - box.low;
    return sum / (size.x * size.y);
}

#endif
