#include "reference/tile_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "input/input_error.h"
#include "parameters/matrix_row.h"

namespace penumbra::reference {
namespace {

double quantum(scene::DepthFormat format) {
  switch (format) {
    case scene::DepthFormat::d16:
      return 1.0 / 65535.0;
    case scene::DepthFormat::d24:
      return 1.0 / 16777215.0;
    case scene::DepthFormat::d32:
      break;
  }
  return 0x1p-24;
}

}  // namespace

TileSearch::TileSearch(const scene::ShadowAtlas& atlas, const parameters::CascadeSet& cascades,
                       std::size_t cascade)
    : depths_(atlas, cascades.cascades[cascade], cascades.reversed_z),
      world_to_shadow_(cascades.cascades[cascade].world_to_shadow),
      height_sign_(cascades.reversed_z ? 1.0 : -1.0) {
  const glm::dvec3 across = parameters::matrix_row(world_to_shadow_, 0);
  const glm::dvec3 along = parameters::matrix_row(world_to_shadow_, 1);
  const glm::dvec3 depth = height_sign_ * parameters::matrix_row(world_to_shadow_, 2);
  const glm::dvec3 lengths(glm::length(across), glm::length(along), glm::length(depth));
  if (!(lengths.x > 0.0 && lengths.y > 0.0 && lengths.z > 0.0)) {
    throw InputError("", "a cascade's world_to_shadow matrix is singular");
  }
  right_ = across / lengths.x;
  up_ = along / lengths.y;
  to_light_ = depth / lengths.z;
  metres_per_uv_ = 1.0 / glm::dvec2(lengths);
  metres_per_depth_ = 1.0 / lengths.z;
  const glm::dvec2 texel_uv = 1.0 / glm::dvec2(atlas.width, atlas.height);
  corner_uv_ = glm::dvec2(depths_.first_column(), depths_.first_row()) * texel_uv;
  texel_metres_ = texel_uv * metres_per_uv_;
  quantum_metres_ = quantum(atlas.format) * metres_per_depth_;
}

TileSearch::Seen TileSearch::seen_from_light(const LitReceiver& receiver) const {
  const glm::dvec4 shadow = world_to_shadow_ * glm::dvec4(receiver.position, 1.0);
  const double facing = glm::dot(receiver.normal, to_light_);
  return {(glm::dvec2(shadow) - corner_uv_) * metres_per_uv_, height_sign_ * shadow.z,
          -glm::dvec2(glm::dot(receiver.normal, right_), glm::dot(receiver.normal, up_)) / facing};
}

DiscRectangle TileSearch::metres_from(const Seen& seen, const Block& block) const {
  const int size = 1 << block.level;
  return {block.column * size * texel_metres_.x - seen.place.x,
          (block.column + 1) * size * texel_metres_.x - seen.place.x,
          block.row * size * texel_metres_.y - seen.place.y,
          (block.row + 1) * size * texel_metres_.y - seen.place.y};
}

// A block can matter only if its nearest texel is above the receiver, and the light's cone, as wide as it is
// at that height, reaches the block.
bool TileSearch::may_block(const Block& block, const DiscRectangle& area, const Seen& seen,
                           double tan_half) const {
  const double largest_gap = gap(depths_.nearest(block.level, block.column, block.row), seen);
  if (!(largest_gap > quantum_metres_)) return false;
  const double aside = std::max({area.left, -area.right, 0.0});
  const double away = std::max({area.bottom, -area.top, 0.0});
  const double reach = tan_half * largest_gap;
  return aside * aside + away * away <= reach * reach;
}

bool TileSearch::texel_blocks(const DiscRectangle& area, const Seen& seen, double texel_gap) const {
  const glm::dvec2 centre(0.5 * (area.left + area.right), 0.5 * (area.bottom + area.top));
  return texel_gap > quantum_metres_ && texel_gap > glm::dot(seen.slope, centre) + quantum_metres_;
}

DiscPoints::Set TileSearch::covered(const LitReceiver& receiver, double tan_half,
                                    const DiscPoints& points) const {
  const Seen seen = seen_from_light(receiver);
  DiscPoints::Set covered{};
  std::array<Block, 64> stack;  // at most three siblings wait on each of the up to 16 levels
  std::size_t waiting = 0;
  stack[waiting++] = {depths_.level_count() - 1, 0, 0};
  while (waiting > 0) {
    const Block block = stack[--waiting];
    const DiscRectangle area = metres_from(seen, block);
    if (!may_block(block, area, seen, tan_half)) continue;
    if (block.level == 0) {
      const double texel_gap = gap(depths_.nearest(0, block.column, block.row), seen);
      if (!texel_blocks(area, seen, texel_gap)) continue;
      const double to_disc = 1.0 / (tan_half * texel_gap);
      points.cover({area.left * to_disc, area.right * to_disc, area.bottom * to_disc, area.top * to_disc},
                   covered);
      continue;
    }
    if (block.level == 3 && DiscPoints::all(covered)) break;
    for (int child = 0; child < 4; ++child) {
      const Block quarter{block.level - 1, 2 * block.column + (child & 1), 2 * block.row + (child >> 1)};
      if (depths_.inside(quarter.level, quarter.column, quarter.row)) stack[waiting++] = quarter;
    }
  }
  return covered;
}

bool TileSearch::blocked(const LitReceiver& receiver) const {
  const Seen seen = seen_from_light(receiver);
  const glm::dvec2 texel = glm::floor(seen.place / texel_metres_);
  if (!(texel.x >= 0.0 && texel.y >= 0.0 && texel.x < depths_.width() && texel.y < depths_.height())) {
    return false;
  }
  const Block block{0, static_cast<int>(texel.x), static_cast<int>(texel.y)};
  return texel_blocks(metres_from(seen, block), seen, gap(depths_.nearest(0, block.column, block.row), seen));
}

}  // namespace penumbra::reference
