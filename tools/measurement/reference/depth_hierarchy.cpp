#include "reference/depth_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "input/input_error.h"

namespace penumbra::reference {
namespace {

constexpr float no_caster = -std::numeric_limits<float>::infinity();

float height_of(float depth, bool reversed_z) {
  if (!(depth >= 0.0F && depth <= 1.0F)) return no_caster;
  if (reversed_z) return depth == 0.0F ? no_caster : depth;
  return depth == 1.0F ? no_caster : -depth;
}

int whole_texel(double uv, int size) {
  return std::clamp(static_cast<int>(std::lround(uv * size)), 0, size);
}

}  // namespace

DepthHierarchy::DepthHierarchy(const scene::ShadowAtlas& atlas, const parameters::Cascade& cascade,
                               bool reversed_z) {
  const glm::dvec4& tile = cascade.offset_scale;
  first_column_ = whole_texel(tile.x, atlas.width);
  first_row_ = whole_texel(tile.y, atlas.height);
  Level texels;
  texels.width = whole_texel(tile.x + tile.z, atlas.width) - first_column_;
  texels.height = whole_texel(tile.y + tile.w, atlas.height) - first_row_;
  if (texels.width <= 0 || texels.height <= 0)
    throw InputError("", "a cascade's tile lies outside the atlas");
  for (int row = first_row_; row < first_row_ + texels.height; ++row) {
    const float* line =
        atlas.depth.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(atlas.width);
    for (int column = first_column_; column < first_column_ + texels.width; ++column) {
      texels.heights.push_back(height_of(line[column], reversed_z));
    }
  }
  levels_.push_back(std::move(texels));
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(half_size(levels_.back()));
}

DepthHierarchy::Level DepthHierarchy::half_size(const Level& finer) {
  Level coarser{(finer.width + 1) / 2, (finer.height + 1) / 2, {}};
  coarser.heights.assign(static_cast<std::size_t>(coarser.width) * static_cast<std::size_t>(coarser.height),
                         no_caster);
  for (int row = 0; row < finer.height; ++row) {
    for (int column = 0; column < finer.width; ++column) {
      float& block =
          coarser.heights[static_cast<std::size_t>(row / 2) * static_cast<std::size_t>(coarser.width) +
                          static_cast<std::size_t>(column / 2)];
      block = std::max(block,
                       finer.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(finer.width) +
                                     static_cast<std::size_t>(column)]);
    }
  }
  return coarser;
}

}  // namespace penumbra::reference
