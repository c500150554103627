// A filter that removes the noise of light gathered by few rays without blurring across edges.
//
// Source: H. Dammertz et al., "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination
// Filtering" (HPG 2010). Passes of a 5 x 5 B3 spline, whose taps stand twice as far apart each time, are
// weighted by how alike the neighbour's normal is and how near it lies to the pixel's plane. The neighbour's
// colour does not enter the weight, so the filter is linear in the light and adds no bias where the light is
// constant. Guarantees: each result is a weighted mean of the pixels around; pixels that show the sky are
// neither sources nor results. Deterministic.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "lighting/seen_materials.h"
#include "reference/row_blocks.h"

namespace penumbra::lighting {

std::vector<glm::vec3> smoothed(const SeenMaterials& seen, std::vector<glm::vec3> light, int passes,
                                const reference::RunOptions& run = {});

}  // namespace penumbra::lighting
