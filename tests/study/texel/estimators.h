// Ways to tell the covered share of a disc around a receiver from the bits of the shadow map's texels.
#pragma once

#include "study/texel/shapes.h"

namespace penumbra::texel {

// Bilinear weights of the four texels around the receiver.
double bilinear(Point place, const Texels& texels);

// Weighs each texel of the 4 x 4 by the area of its square in a disc of that radius, at most 1.5.
double disc_kernel(Point place, const Texels& texels, double radius);

// The kernel of narrow penumbrae in ShaderLibrary/Filters/Pcss/PcssAngular.hlsl weighs each texel of the 4 x
// 4 by a weight that falls evenly with the distance of its centre. radius is limited as minFilterTexels, to
// at most 1.25.
double shipped_kernel(Point place, const Texels& texels, double radius);

// A straight edge through the 4 x 4 texels. Its direction is that of the plane which fits the bits best
// (least squares). Across it, it lies in the middle of the room that the texels leave.
struct FittedEdge {
  bool found;     // false where the bits have no direction
  Point normal;   // towards the blocker
  double offset;  // offset of the edge along the normal
  double room;    // half of the room that the texels leave, texels; 0 where no edge of that direction fits
  double misfit;  // how far texels lie on the wrong side, texels
};
FittedEdge fitted_edge(std::uint16_t block);

// The disc's exact share of the fitted edge. Where the edge does not fit, it gives way to the disc kernel of
// that radius.
double fit_of_edge(Point place, const Texels& texels, double radius, double kernel);

// The mean of the disc's shares over all edges in the room that the texels leave.
double mean_fit_of_edge(Point place, const Texels& texels, double radius, double kernel);

// Revectorization as in Macedo and Apolinario 2016 goes along each border between covered and clear texels,
// to where it ends, at most `reach` texels from the middle; a straight line from end to end takes the
// border's place. The result is the share of 128 points of the disc on the blocker's side.
double revectorised(Point place, const Texels& texels, double radius, int reach);

// Whether the revectorised blocker covers a point of the 4 x 4 texels.
bool covers_revectorised(const Texels& texels, Point point, int reach);

}  // namespace penumbra::texel
